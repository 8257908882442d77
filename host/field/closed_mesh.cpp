#include "host/field/closed_mesh.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <locale>
#include <optional>
#include <sstream>
#include <utility>

#include "host/error.h"
#include "host/field/face_edges.h"
#include "host/field/line_crossings.h"
#include "host/field/nearest.h"
#include "host/field/parallel.h"
#include "host/field/sheets.h"

namespace isotouch::field {

namespace {

using Eigen::Vector3d;
using Edge = std::pair<std::uint32_t, std::uint32_t>;  // as a face runs it

constexpr double kLeastVolume = 1e-9;  // of the box's diagonal cubed: below it is rounding
constexpr double kHardlyShared = 0.9;  // of the edges: on a rim
constexpr double kLeastArea = 1e-5;    // of the box's diagonal squared: less of an open sheet refuses no mesh

std::string text(double value) {
  std::ostringstream stream;
  stream.imbue(std::locale::classic());
  stream << value;
  return stream.str();
}

std::string text(const Vector3d& p) { return '(' + text(p.x()) + ", " + text(p.y()) + ", " + text(p.z()) + ')'; }

std::string count_of(std::size_t count, const char* one, const char* many) {
  return std::to_string(count) + ' ' + (count == 1 ? one : many);
}

std::string rims(const MeshRepair& repair) {
  return "the mesh is open: " + count_of(repair.holes, "rim", "rims") + " of " + text(repair.rim_length) +
         " units length together, the longest round " + text(repair.rim);
}

double diagonal(const cloud::TriangleMesh& mesh) {
  Eigen::AlignedBox3d box;
  for (const Vector3d& vertex : mesh.vertices) box.extend(vertex);
  return box.diagonal().norm();
}

/// The edges that are run more often in this direction than in the other, as often as that, sorted; with the checks on all others.
std::vector<Edge> rim_edges(const cloud::TriangleMesh& mesh, const std::string& name, MeshRepair& repair) {
  const std::vector<FaceEdge> edges = face_edges(mesh);
  std::vector<Edge> rim;
  std::size_t against = 0;
  Vector3d first_against = Vector3d::Zero();
  for (std::size_t begin = 0, end = 0; begin < edges.size(); begin = end) {
    std::size_t back = 0;
    for (; end < edges.size() && edges[end].same_edge(edges[begin]); ++end)
      if (edges[end].is_back(mesh)) ++back;
    const std::uint32_t low = edges[begin].low, high = edges[begin].high;
    const std::size_t faces = end - begin;
    const std::size_t forward = faces - back;
    if (faces == 2 && forward == back) continue;
    const Vector3d middle = (mesh.vertices[low] + mesh.vertices[high]) / 2;
    if (faces == 2 && forward != back && against++ == 0) first_against = middle;
    if (faces > 2 && repair.branching++ == 0) repair.branch = middle;
    for (std::size_t i = back; i < forward; ++i) rim.emplace_back(low, high);
    for (std::size_t i = forward; i < back; ++i) rim.emplace_back(high, low);
  }
  if (against > 0) {
    throw InputError(name + ": at " + count_of(against, "edge", "edges") +
                     " neighbouring faces are oriented against each other, first near " + text(first_against) +
                     "; make the faces' directions consistent in a mesh program");
  }
  std::sort(rim.begin(), rim.end());
  return rim;
}

/// Cuts the rim into loops that pass no vertex twice. As many edges end at a vertex as begin there, so a walk ends only where it began.
std::vector<std::vector<std::uint32_t>> loops_of(const std::vector<Edge>& rim) {
  std::vector<std::vector<std::uint32_t>> loops;
  std::vector<bool> used(rim.size());
  std::vector<std::uint32_t> path;
  for (std::size_t start = 0; start < rim.size(); ++start) {
    if (used[start]) continue;
    path.assign(1, rim[start].first);
    for (std::size_t at = start;;) {
      used[at] = true;
      const std::uint32_t next = rim[at].second;
      const auto again = std::find(path.begin(), path.end(), next);
      if (again != path.end()) {
        loops.emplace_back(again, path.end());
        path.erase(again, path.end());
      }
      path.push_back(next);
      if (path.size() == 1) break;
      at = static_cast<std::size_t>(std::lower_bound(rim.begin(), rim.end(), Edge{next, 0}) - rim.begin());
      while (used[at]) ++at;
    }
  }
  return loops;
}

void close_holes(cloud::TriangleMesh& mesh, const std::vector<Edge>& rim, MeshRepair& repair) {
  double longest = 0;
  for (const auto& loop : loops_of(rim)) {
    ++repair.holes;
    Vector3d centre = Vector3d::Zero();
    double length = 0;
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const Vector3d& a = mesh.vertices[loop[i]];
      const Vector3d& b = mesh.vertices[loop[(i + 1) % loop.size()]];
      centre += (b - a).norm() * (a + b) / 2;
      length += (b - a).norm();
    }
    centre /= length;
    repair.rim_length += length;
    if (length > longest) {
      longest = length;
      repair.rim = centre;
    }
    if (loop.size() == 3) {
      mesh.faces.push_back({loop[2], loop[1], loop[0]});
      continue;
    }
    const auto middle = static_cast<std::uint32_t>(mesh.vertices.size());
    mesh.vertices.push_back(centre);
    for (std::size_t i = 0; i < loop.size(); ++i) mesh.faces.push_back({loop[(i + 1) % loop.size()], loop[i], middle});
  }
}

/// How far the corners of faces lie from the nearest corner of another face, the median of some; nothing where that is no small part of an edge.
///
/// mesh      hardly any of its faces share corners
std::optional<double> gap_between_faces(const cloud::TriangleMesh& mesh) {
  constexpr std::size_t kAsked = 2000, kFound = 8;
  constexpr double kSmall = 0.25;  // of an edge
  const Nearest corners(mesh.vertices);
  std::vector<double> gaps, edges;
  std::vector<Neighbour> found;
  const std::size_t step = std::max<std::size_t>(1, mesh.faces.size() / kAsked);
  for (std::size_t i = 0; i < mesh.faces.size(); i += step) {
    const std::array<std::uint32_t, 3>& face = mesh.faces[i];
    const Vector3d& corner = mesh.vertices[face[0]];
    corners.nearest(corner, kFound, found);
    const auto other = std::find_if(found.begin(), found.end(),
                                    [&](const Neighbour& n) { return std::find(face.begin(), face.end(), n.index) == face.end(); });
    if (other == found.end()) continue;
    gaps.push_back(std::sqrt(other->squared_distance));
    edges.push_back((mesh.vertices[face[1]] - corner).norm());
  }
  const auto median = [](std::vector<double>& values) {
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
  };
  if (gaps.empty()) return std::nullopt;
  const double gap = median(gaps);
  return gap < kSmall * median(edges) ? std::optional(gap) : std::nullopt;
}

/// Is every edge run as often in one direction as in the other?
bool is_balanced(const cloud::TriangleMesh& mesh) {
  const std::vector<FaceEdge> edges = face_edges(mesh);
  for (std::size_t begin = 0, end = 0; begin < edges.size(); begin = end) {
    std::size_t back = 0;
    for (; end < edges.size() && edges[end].same_edge(edges[begin]); ++end) back += edges[end].is_back(mesh) ? 1U : 0U;
    if (2 * back != end - begin) return false;
  }
  return true;
}

/// Keeps each face once, whatever corner it is written from. Returns how many were dropped.
std::size_t drop_repeated(std::vector<std::array<std::uint32_t, 3>>& faces) {
  const auto from_least = [](std::array<std::uint32_t, 3> face) {
    std::rotate(face.begin(), std::min_element(face.begin(), face.end()), face.end());
    return face;
  };
  std::vector<std::pair<std::array<std::uint32_t, 3>, std::size_t>> sorted;
  sorted.reserve(faces.size());
  for (std::size_t face = 0; face < faces.size(); ++face) sorted.emplace_back(from_least(faces[face]), face);
  std::sort(sorted.begin(), sorted.end());
  std::vector<bool> repeats(faces.size());
  for (std::size_t i = 1; i < sorted.size(); ++i) repeats[sorted[i].second] = sorted[i].first == sorted[i - 1].first;
  std::size_t kept = 0;
  for (std::size_t face = 0; face < faces.size(); ++face) {
    if (!repeats[face]) faces[kept++] = faces[face];
  }
  const std::size_t dropped = faces.size() - kept;
  faces.resize(kept);
  return dropped;
}

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

/// In front of the faces of a sheet that faces inward lies what the sheet encloses. In a hollow nothing winds round that place. An open sheet
/// encloses nothing by itself: it faces inward if that is so in front of the larger part of it. Where hollows overlap, a place counts less than
/// nothing, as it does beside all bodies. Hollows may overlap; but what lies wholly in others may as well be a body, and no body may lie there.
///
/// first_fan   the faces from this one on close holes
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
                              count_of(static_cast<std::size_t>(std::count(sheet.begin(), sheet.end(), of)), "face", "faces") + " near " +
                              text((mesh.vertices[a] + mesh.vertices[b] + mesh.vertices[c]) / 3);
    std::string what = trouble(piece, turned_body, found[n].nothing, repair.turned);
    if (has_fans[of] != 0) what = what.substr(0, what.rfind(';')) + "; join or close the rims in a mesh program";
    throw InputError(name + ": " + (repair.holes > 0 ? rims(repair) + "; when fans of faces close them, " : "") + what);
  }
}

}  // namespace

cloud::TriangleMesh closed_mesh(cloud::TriangleMesh mesh, const std::string& name, MeshRepair& repair) {
  repair = MeshRepair{};
  if (!is_balanced(mesh)) repair.repeated = drop_repeated(mesh.faces);
  const std::vector<Edge> rim = rim_edges(mesh, name, repair);
  if (static_cast<double>(rim.size()) > kHardlyShared * 3 * static_cast<double>(mesh.faces.size())) {
    if (const auto gap = gap_between_faces(mesh)) {
      throw InputError(name + ": neighbouring faces do not share their corners, which lie about " + text(*gap) +
                       " units apart; merge vertices by distance in a mesh program");
    }
  }
  const std::size_t first_fan = mesh.faces.size();
  close_holes(mesh, rim, repair);
  const double size = diagonal(mesh);
  const double volume = cloud::signed_volume(mesh);
  if (!(std::abs(volume) > kLeastVolume * size * size * size)) {
    throw InputError(name + ": the faces enclose nothing" + (repair.holes > 0 ? ", also when its rim is closed" : "") +
                     ", or those that point inwards as much as those that point outwards; "
                     "a body needs a surface on all sides, and all of it points outwards");
  }
  repair.turned = volume < 0;
  if (repair.turned) {
    for (auto& face : mesh.faces) std::swap(face[1], face[2]);
  }
  require_hollows(mesh, name, size, first_fan, repair);
  return mesh;
}

std::vector<std::string> MeshRepair::warnings() const {
  std::vector<std::string> list;
  if (holes > 0) {
    list.push_back(rims(*this) + ", closed by fans of faces" +
                   (holes > 1 ? "; where one rim lies round another, join the two in a mesh program instead" : ""));
  }
  if (repeated > 0) list.push_back(count_of(repeated, "face was", "faces were") + " written more than once; each was kept once");
  if (branching > 0) {
    list.push_back(count_of(branching, "edge has", "edges have") + " more than two faces, the first near " + text(branch) +
                   "; inside is what the faces wind round");
  }
  if (crossing > 0) {
    list.push_back("the mesh runs through itself: " + count_of(crossing, "face crosses", "faces cross") + " others, the first near " +
                   text(cross) + "; inside is what the faces wind round");
  }
  if (coarse > 0) {
    list.push_back("so many faces cross that they were cut only into parts of " + text(1000 * coarse) +
                   " thousandths of the mesh's size; where gaps or pieces are narrower, the surface may be wrong; unite the pieces in a "
                   "mesh program");
  }
  if (swallowed > 0) {
    list.push_back(count_of(swallowed, "closed piece lies", "closed pieces lie") + " within others and " +
                   (swallowed == 1 ? "has" : "have") + " no effect, the first near " + text(swallow) +
                   "; reverse the faces of those that are hollows");
  }
  if (turned) list.push_back("the faces pointed inwards; all were reversed");
  return list;
}

}  // namespace isotouch::field
