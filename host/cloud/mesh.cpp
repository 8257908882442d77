#include "host/cloud/mesh.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "host/cloud/random.h"
#include "host/error.h"

namespace isotouch::cloud {
namespace {

using Eigen::Vector3d;

/// Twice the face's area, along its normal.
Vector3d area_vector(const TriangleMesh& mesh, std::size_t face) {
  const auto& [a, b, c] = mesh.faces[face];
  return (mesh.vertices[b] - mesh.vertices[a]).cross(mesh.vertices[c] - mesh.vertices[a]);
}

std::string text(const Vector3d& p) { return std::to_string(p.x()) + ' ' + std::to_string(p.y()) + ' ' + std::to_string(p.z()); }

}  // namespace

TriangleMesh placed(TriangleMesh mesh, const Placement& placement) {
  for (Vector3d& vertex : mesh.vertices) vertex = placement.to_workspace(vertex);
  return mesh;
}

void require_closed(const TriangleMesh& mesh, const std::string& name) {
  using Edge = std::pair<std::uint32_t, std::uint32_t>;
  std::vector<Edge> edges;  // as the faces run them
  edges.reserve(3 * mesh.faces.size());
  for (const auto& [a, b, c] : mesh.faces) {
    edges.emplace_back(a, b);
    edges.emplace_back(b, c);
    edges.emplace_back(c, a);
  }
  std::sort(edges.begin(), edges.end());
  std::size_t open = 0;
  Edge first_open;
  for (std::size_t i = 0; i < edges.size(); ++i) {
    const bool twice = (i > 0 && edges[i] == edges[i - 1]) || (i + 1 < edges.size() && edges[i] == edges[i + 1]);
    const bool answered = std::binary_search(edges.begin(), edges.end(), Edge{edges[i].second, edges[i].first});
    if (!twice && answered) continue;
    if (open++ == 0) first_open = edges[i];
  }
  if (open > 0) {
    throw InputError(name + ": the mesh is not closed: " + std::to_string(open) + " of its " + std::to_string(edges.size()) +
                     " face edges have not exactly one opposite, the first from " + text(mesh.vertices[first_open.first]) + " to " +
                     text(mesh.vertices[first_open.second]) + "; repair it first");
  }
  if (!(signed_volume(mesh) > 0.0)) throw InputError(name + ": the mesh is closed but its faces point inwards; reverse them first");
}

double signed_volume(const TriangleMesh& mesh) {
  if (mesh.vertices.empty()) return 0.0;
  const Vector3d& origin = mesh.vertices[0];  // near the mesh, so that little cancels
  double six_volumes = 0.0;
  for (const auto& [a, b, c] : mesh.faces) {
    six_volumes += (mesh.vertices[a] - origin).dot((mesh.vertices[b] - origin).cross(mesh.vertices[c] - origin));
  }
  return six_volumes / 6.0;
}

Vector3d face_normal(const TriangleMesh& mesh, std::size_t face) {
  const Vector3d across = area_vector(mesh, face);
  const double length = across.norm();
  return length > 0.0 ? Vector3d(across / length) : Vector3d::Zero();
}

OrientedPoints scatter_on_mesh(const TriangleMesh& mesh, std::size_t count, std::uint64_t seed) {
  std::vector<double> area_up_to;
  double area = 0.0;
  for (std::size_t face = 0; face < mesh.faces.size(); ++face) area_up_to.push_back(area += area_vector(mesh, face).norm());
  if (!(area > 0.0)) throw InputError("the mesh has no area to draw points from");
  Random random(seed);
  OrientedPoints points;
  while (points.size() < count) {
    const auto found = std::upper_bound(area_up_to.begin(), area_up_to.end(), random.uniform() * area);
    const double spread = std::sqrt(random.uniform());
    const double along = random.uniform();
    if (found == area_up_to.end()) continue;  // by rounding only
    const auto face = static_cast<std::size_t>(found - area_up_to.begin());
    const auto& [a, b, c] = mesh.faces[face];
    points.positions.emplace_back((1.0 - spread) * mesh.vertices[a] + spread * (1.0 - along) * mesh.vertices[b] +
                                  spread * along * mesh.vertices[c]);
    points.normals.push_back(face_normal(mesh, face));
  }
  return points;
}

std::vector<std::uint32_t> pieces_of_vertices(const TriangleMesh& mesh) {
  std::vector<std::uint32_t> parent(mesh.vertices.size());
  std::iota(parent.begin(), parent.end(), 0U);
  const auto root = [&](std::uint32_t v) {
    while (parent[v] != v) v = parent[v] = parent[parent[v]];
    return v;
  };
  for (const auto& [a, b, c] : mesh.faces) {
    for (const std::uint32_t other : {b, c}) {
      const std::uint32_t p = root(a), q = root(other);
      parent[std::max(p, q)] = std::min(p, q);
    }
  }
  for (std::uint32_t v = 0; v < parent.size(); ++v) parent[v] = root(v);
  return parent;
}

}  // namespace isotouch::cloud
