#include "host/field/mesh_hollows.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cstdint>
#include <vector>

#include "host/error.h"
#include "host/field/line_crossings.h"
#include "host/field/nearest.h"
#include "host/field/parallel.h"
#include "host/field/sheets.h"

namespace isotouch::field {

namespace {

using Eigen::Vector3d;

constexpr double kLeastArea = 1e-5;  // of the box's diagonal squared: less of an open sheet refuses no mesh

/// In front of every face of a closed sheet that faces outward lies what others enclose: then nothing of it bounds the body. Most sheets show that they are
/// none of these by their first face.
///
/// faces_out   called with a face: is its sheet closed, and does it face outward?
template <typename FacesOut>
void count_swallowed(const TriangleTree& tree, const cloud::TriangleMesh& mesh, const std::vector<std::uint32_t>& sheet, double ahead,
                     const FacesOut& faces_out, MeshRepair& repair) {
  std::vector<std::uint8_t> may_be(mesh.faces.size(), 1);  // of a sheet
  std::vector<std::uint32_t> inner;
  const auto middle = [&](std::uint32_t face) {
    const Corners corners = tree.corners(face);
    return Vector3d((corners[0] + corners[1] + corners[2]) / 3);
  };
  for (std::uint32_t face = 0; face < mesh.faces.size(); ++face) {
    std::uint8_t& all_in = may_be[sheet[face]];
    if (all_in != 0) all_in = faces_out(face) && is_inside(tree, middle(face) + ahead * cloud::face_normal(mesh, face)) ? 1 : 0;
  }
  for (std::uint32_t face = 0; face < mesh.faces.size(); ++face) {
    if (may_be[face] == 0 || sheet[face] != face) continue;
    if (repair.swallowed++ == 0) repair.swallow = middle(face);
  }
}

/// Six times the volume of each sheet or piece, at the place of the face that stands for it.
std::vector<double> six_volumes_of(const cloud::TriangleMesh& mesh, const std::vector<std::uint32_t>& of) {
  std::vector<double> six_volumes(mesh.faces.size());
  for (std::size_t face = 0; face < mesh.faces.size(); ++face) {
    const Vector3d& origin = mesh.vertices[mesh.faces[of[face]][0]];
    const auto& [a, b, c] = mesh.faces[face];
    six_volumes[of[face]] += (mesh.vertices[a] - origin).dot((mesh.vertices[b] - origin).cross(mesh.vertices[c] - origin));
  }
  return six_volumes;
}

/// The pieces that face outward: without hollows, and without bodies that face inward.
cloud::TriangleMesh outward_pieces(const cloud::TriangleMesh& mesh) {
  const std::vector<std::uint32_t> piece = pieces_of_faces(mesh);
  const std::vector<double> six_volumes = six_volumes_of(mesh, piece);
  cloud::TriangleMesh outward{mesh.vertices, {}};
  for (std::size_t face = 0; face < mesh.faces.size(); ++face) {
    if (six_volumes[piece[face]] > 0) outward.faces.push_back(mesh.faces[face]);
  }
  return outward;
}

/// What lies in front of a face.
struct Ahead {
  bool nothing = false;      ///< somewhere, no body
  bool overlap = false;      ///< somewhere, a body with several hollows
  bool all_overlap = false;  ///< that everywhere
};

/// What is wrong with a piece, and after the semicolon what to do.
///
/// inward    it faces inward; else a body lies where hollows overlap
/// nothing   and there is no body round it
/// turned    the file's faces were all turned round
std::string trouble(const std::string& piece, bool inward, bool nothing, bool turned) {
  if (!inward) return piece + " lies where hollows overlap; unite the hollows in a mesh program";
  if (!nothing) {
    return piece + " has faces that point " + (turned ? "outwards" : "inwards") +
           ", and lies in a hollow; reverse its faces if it is a body, or remove it if it is a hollow";
  }
  if (turned) return "most faces point inwards, but those of " + piece + " point outwards; reverse all others";
  return piece + " has faces that point inwards, and there it lies in no other piece; reverse its faces";
}

}  // namespace

void require_hollows(const cloud::TriangleMesh& mesh, const std::string& name, double size, std::size_t first_fan, MeshRepair& repair) {
  const Sheets sheets = sheets_of(mesh);
  const std::vector<std::uint32_t>& sheet = sheets.of;
  const std::vector<double> six_volumes = six_volumes_of(mesh, sheet);
  const double noise = 6 * kLeastVolume * size * size * size;
  const auto is_open = [&](std::uint32_t face) { return sheets.open[sheet[face]] != 0; };
  const auto is_inward = [&](std::uint32_t face) { return !is_open(face) && six_volumes[sheet[face]] < -noise; };
  const auto is_outward = [&](std::uint32_t face) { return !is_open(face) && six_volumes[sheet[face]] > noise; };
  std::vector<std::uint8_t> hollow(mesh.faces.size());  // a sheet
  for (std::uint32_t face = 0; face < mesh.faces.size(); ++face) {
    if (is_inward(face)) hollow[sheet[face]] = 1;
  }
  const bool may_overlap = std::count(hollow.begin(), hollow.end(), 1) > 1;  // then a body may lie where two do, before no face of theirs
  std::vector<std::uint32_t> asked;
  for (std::uint32_t face = 0; face < mesh.faces.size(); ++face) {
    if (is_inward(face) || is_open(face) || (may_overlap && is_outward(face))) asked.push_back(face);
  }
  const bool is_one = std::all_of(sheet.begin(), sheet.end(), [&](std::uint32_t of) { return of == sheet[0]; });
  if (asked.empty() && is_one) return;
  const TriangleTree tree(mesh);
  if (!is_one) count_swallowed(tree, mesh, sheet, 1e-6 * size, is_outward, repair);
  std::vector<Ahead> found;
  const auto look_ahead = [&](const TriangleTree* bodies) {
    found.assign(asked.size(), Ahead{});
    in_parallel(asked.size(), 64, [&](std::size_t begin, std::size_t end) {
      for (std::size_t n = begin; n < end; ++n) {
        const Corners corners = tree.corners(asked[n]);
        const Vector3d middle = (corners[0] + corners[1] + corners[2]) / 3, ahead = 1e-6 * size * cloud::face_normal(mesh, asked[n]);
        bool any_else = false;
        const auto look = [&](const Vector3d& place) {
          const bool less = turns_round(tree, place + ahead) < 0, in_body = less && bodies != nullptr && is_inside(*bodies, place + ahead);
          found[n].nothing |= less && !in_body;
          found[n].overlap |= in_body;
          any_else |= !in_body;
        };
        look(middle);
        if (!is_open(asked[n])) {
          for (const Vector3d& corner : corners) look(middle + 0.999 * (corner - middle));  // what sticks out of a piece may be a corner
        }
        found[n].all_overlap = !any_else;
      }
    });
  };
  look_ahead(nullptr);
  if (std::none_of(found.begin(), found.end(), [](const Ahead& ahead) { return ahead.nothing; })) return;
  for (std::uint32_t face = 0; face < mesh.faces.size(); ++face) {
    if (!may_overlap && is_outward(face)) asked.push_back(face);
  }
  const cloud::TriangleMesh outward = outward_pieces(mesh);
  const TriangleTree bodies(outward);
  look_ahead(&bodies);

  std::vector<double> surplus(mesh.faces.size());  // of a sheet's area, twice: in front of it is nothing
  std::vector<std::uint8_t> in_hollows(mesh.faces.size(), 1), has_fans(mesh.faces.size());  // of a sheet
  for (std::size_t n = 0; n < asked.size(); ++n) {
    const Corners corners = tree.corners(asked[n]);
    const double area = (corners[1] - corners[0]).cross(corners[2] - corners[0]).norm();
    surplus[sheet[asked[n]]] += found[n].nothing || found[n].overlap ? area : -area;
    if (!found[n].all_overlap) in_hollows[sheet[asked[n]]] = 0;
  }
  for (std::size_t face = first_fan; face < mesh.faces.size(); ++face) has_fans[sheet[face]] = 1;
  for (std::size_t n = 0; n < asked.size(); ++n) {
    const std::uint32_t face = asked[n], of = sheet[face];
    const bool turned_body = is_open(face) ? (found[n].nothing || found[n].overlap) && surplus[of] > 2 * kLeastArea * size * size
                                           : is_inward(face) && (found[n].nothing || in_hollows[of] != 0);
    if (!turned_body && !(is_outward(face) && found[n].overlap)) continue;
    const auto& [a, b, c] = mesh.faces[face];
    const std::string piece = (is_open(face) || has_fans[of] != 0 ? "a piece of " : "a closed piece of ") +
                              count_text(static_cast<std::size_t>(std::count(sheet.begin(), sheet.end(), of)), "face", "faces") + " near " +
                              place_text((mesh.vertices[a] + mesh.vertices[b] + mesh.vertices[c]) / 3);
    std::string what = trouble(piece, turned_body, found[n].nothing, repair.turned);
    if (has_fans[of] != 0) what = what.substr(0, what.rfind(';')) + "; join or close the rims in a mesh program";
    throw InputError(name + ": " + (repair.holes > 0 ? rims_text(repair) + "; when fans of faces close them, " : "") + what);
  }
}

}  // namespace isotouch::field
