#include "host/field/closed_mesh.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <locale>
#include <numeric>
#include <sstream>
#include <utility>

#include "host/error.h"
#include "host/field/face_edges.h"
#include "host/field/line_crossings.h"

namespace isotouch::field {

namespace {

using Eigen::Vector3d;
using Edge = std::pair<std::uint32_t, std::uint32_t>;  // as a face runs it

constexpr double kLeastVolume = 1e-9;  // of the box's diagonal cubed: below it is rounding

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

/// A piece: faces that hang together by their corners.
struct Piece {
  double six_volumes = 0;
  std::size_t largest = 0;  ///< its face of largest area
  double largest_area = 0;
  std::size_t faces = 0;
};

std::vector<Piece> pieces_of(const cloud::TriangleMesh& mesh) {
  const std::vector<std::uint32_t> root = cloud::pieces_of_vertices(mesh);
  std::vector<Piece> by_root(mesh.vertices.size());
  for (std::size_t face = 0; face < mesh.faces.size(); ++face) {
    const auto& [a, b, c] = mesh.faces[face];
    const std::uint32_t number = root[a];
    Piece& piece = by_root[number];
    const Vector3d& origin = mesh.vertices[number];
    piece.six_volumes += (mesh.vertices[a] - origin).dot((mesh.vertices[b] - origin).cross(mesh.vertices[c] - origin));
    const double area = (mesh.vertices[b] - mesh.vertices[a]).cross(mesh.vertices[c] - mesh.vertices[a]).norm();
    if (piece.faces++ == 0 || area > piece.largest_area) {
      piece.largest = face;
      piece.largest_area = area;
    }
  }
  by_root.erase(std::remove_if(by_root.begin(), by_root.end(), [](const Piece& p) { return p.faces == 0; }), by_root.end());
  return by_root;
}

/// In front of a piece's face that faces inward lies what the piece encloses. In a hollow nothing winds round that place.
void require_hollows(const cloud::TriangleMesh& mesh, const std::string& name, double size) {
  const std::vector<Piece> pieces = pieces_of(mesh);
  const double noise = 6 * kLeastVolume * size * size * size;
  const auto inward = [=](const Piece& piece) { return piece.six_volumes < -noise; };
  if (std::none_of(pieces.begin(), pieces.end(), inward)) return;
  const TriangleTree tree(mesh);
  for (const Piece& piece : pieces) {
    if (!inward(piece)) continue;
    const auto& [a, b, c] = mesh.faces[piece.largest];
    const Vector3d middle = (mesh.vertices[a] + mesh.vertices[b] + mesh.vertices[c]) / 3;
    if (turns_round(tree, middle + 1e-6 * size * cloud::face_normal(mesh, piece.largest)) < 0) {
      throw InputError(name + ": a closed piece of " + count_of(piece.faces, "face", "faces") + " near " + text(middle) +
                       " has faces that point inwards, and it lies in no other piece; reverse its faces");
    }
  }
}

}  // namespace

cloud::TriangleMesh closed_mesh(cloud::TriangleMesh mesh, const std::string& name, MeshRepair& repair) {
  repair = MeshRepair{};
  close_holes(mesh, rim_edges(mesh, name, repair), repair);
  const double size = diagonal(mesh);
  const double volume = cloud::signed_volume(mesh);
  if (!(std::abs(volume) > kLeastVolume * size * size * size)) {
    throw InputError(name + ": the faces enclose nothing" + (repair.holes > 0 ? ", also when its rim is closed" : "") +
                     "; a body needs a surface on all sides");
  }
  repair.turned = volume < 0;
  if (repair.turned) {
    for (auto& face : mesh.faces) std::swap(face[1], face[2]);
  }
  require_hollows(mesh, name, size);
  return mesh;
}

std::vector<std::string> MeshRepair::warnings() const {
  std::vector<std::string> list;
  if (holes > 0) {
    list.push_back("the mesh is open: " + count_of(holes, "rim", "rims") + " of " + text(rim_length) +
                   " units length together, the longest round " + text(rim) + ", closed by fans of faces");
  }
  if (branching > 0) {
    list.push_back(count_of(branching, "edge has", "edges have") + " more than two faces, the first near " + text(branch) +
                   "; inside is what the faces wind round");
  }
  if (crossing > 0) {
    list.push_back("the mesh runs through itself: " + count_of(crossing, "face crosses", "faces cross") + " others, the first near " +
                   text(cross) + "; inside is what the faces wind round");
  }
  if (turned) list.push_back("the faces pointed inwards; all were reversed");
  return list;
}

}  // namespace isotouch::field
