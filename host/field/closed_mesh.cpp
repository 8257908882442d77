#include "host/field/closed_mesh.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <optional>
#include <utility>

#include "host/error.h"
#include "host/field/face_edges.h"
#include "host/field/mesh_hollows.h"
#include "host/field/nearest.h"

namespace isotouch::field {

namespace {

using Eigen::Vector3d;
using Edge = std::pair<std::uint32_t, std::uint32_t>;  // as a face runs it

constexpr double kHardlyShared = 0.9;  // of the edges: on a rim

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
    throw InputError(name + ": at " + count_text(against, "edge", "edges") +
                     " neighbouring faces are oriented against each other, first near " + place_text(first_against) +
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

}  // namespace

cloud::TriangleMesh closed_mesh(cloud::TriangleMesh mesh, const std::string& name, MeshRepair& repair) {
  repair = MeshRepair{};
  if (!is_balanced(mesh)) repair.repeated = drop_repeated(mesh.faces);
  const std::vector<Edge> rim = rim_edges(mesh, name, repair);
  if (static_cast<double>(rim.size()) > kHardlyShared * 3 * static_cast<double>(mesh.faces.size())) {
    if (const auto gap = gap_between_faces(mesh)) {
      throw InputError(name + ": neighbouring faces do not share their corners, which lie about " + length_text(*gap) +
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

}  // namespace isotouch::field
