#include "host/field/mesh_distance.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "host/field/angle.h"
#include "host/field/on_triangle.h"

namespace isotouch::field {

using Eigen::Vector3d;

namespace {

double angle_at(const Vector3d& corner, const Vector3d& b, const Vector3d& c) {
  const Vector3d u = b - corner;
  const Vector3d v = c - corner;
  return angle_of(u.cross(v).norm(), u.dot(v));
}

}  // namespace

MeshDistance::MeshDistance(cloud::TriangleMesh mesh) : mesh_(std::move(mesh)), tree_(mesh_) {
  const bool two_faces_an_edge = make_pseudonormals();
  crossings_ = face_crossings(mesh_, tree_);
  if (!two_faces_an_edge || crossings_.faces > 0) winding_.emplace(tree_);
}

/// Are there two faces at every edge?
bool MeshDistance::make_pseudonormals() {
  struct Edge {
    std::uint32_t low, high, face, side;
    auto operator<=>(const Edge&) const = default;
  };
  vertex_normals_.assign(mesh_.vertices.size(), Vector3d::Zero());
  normals_.resize(mesh_.faces.size());
  std::vector<Edge> edges;
  edges.reserve(3 * mesh_.faces.size());
  for (std::uint32_t face = 0; face < mesh_.faces.size(); ++face) {
    const Vector3d normal = cloud::face_normal(mesh_, face);
    normals_[face][3] = normal;
    const auto& f = mesh_.faces[face];
    for (std::uint32_t i = 0; i < 3; ++i) {
      const std::uint32_t here = f[i];
      const std::uint32_t next = f[(i + 1) % 3];
      const std::uint32_t last = f[(i + 2) % 3];
      vertex_normals_[here] += angle_at(mesh_.vertices[here], mesh_.vertices[next], mesh_.vertices[last]) * normal;
      edges.push_back({std::min(here, next), std::max(here, next), face, i});
    }
  }
  std::sort(edges.begin(), edges.end());
  bool two = true;
  for (std::size_t begin = 0, end = 0; begin < edges.size(); begin = end) {
    Vector3d sum = Vector3d::Zero();
    for (; end < edges.size() && edges[end].low == edges[begin].low && edges[end].high == edges[begin].high; ++end)
      sum += normals_[edges[end].face][3];
    for (std::size_t i = begin; i < end; ++i) normals_[edges[i].face][edges[i].side] = sum;
    two = two && end - begin == 2;
  }
  return two;
}

MeshDistance::Found MeshDistance::on_face(const Vector3d& point, std::uint32_t face) const {
  const auto& [a, b, c] = tree_.faces[face].corners;
  const OnTriangle place = nearest_on_triangle(point, {a, b, c});
  const Vector3d offset = point - place.point;
  return {offset.squaredNorm(), offset, face, place.feature};
}

MeshDistance::Found MeshDistance::nearest(const Vector3d& point, Found best) const {
  const auto square_to_box = [&](std::uint32_t number) {
    const FaceTree::Node& node = tree_.nodes[number];
    return (node.low - point).cwiseMax(point - node.high).cwiseMax(0).squaredNorm();
  };
  std::array<std::pair<std::uint32_t, double>, 64> waiting;
  std::size_t count = 0;
  waiting[count++] = {0, square_to_box(0)};
  while (count > 0) {
    const auto [number, square] = waiting[--count];
    if (square >= best.square) continue;
    const FaceTree::Node& node = tree_.nodes[number];
    if (node.right != 0) {
      std::pair<std::uint32_t, double> near{number + 1, square_to_box(number + 1)};
      std::pair<std::uint32_t, double> far{node.right, square_to_box(node.right)};
      if (far.second < near.second) std::swap(near, far);
      if (far.second < best.square) waiting[count++] = far;
      if (near.second < best.square) waiting[count++] = near;
      continue;
    }
    for (std::uint32_t i = node.first; i < node.first + node.count; ++i) {
      const Found found = on_face(point, i);
      if (found.square < best.square) best = found;
    }
  }
  return best;
}

bool MeshDistance::behind(const Found& found) const {
  const std::uint32_t number = tree_.faces[found.face].number;
  const auto feature = static_cast<std::size_t>(found.feature);
  const Vector3d& normal = feature < 3 ? vertex_normals_[mesh_.faces[number][feature]] : normals_[number][feature - 3];
  return found.offset.dot(normal) < 0;
}

double MeshDistance::operator()(const Vector3d& point) const {
  const Found found = nearest(point, on_face(point, 0));
  const bool inside = winding_ ? (*winding_)(point) > 0.5 : behind(found);
  return inside ? -std::sqrt(found.square) : std::sqrt(found.square);
}

std::array<double, 64> MeshDistance::distances(const Vector3d& first, double step) const {
  constexpr std::array<std::size_t, 3> kBack = {1, 4, 16};  // to the sample before along each axis
  std::array<double, 64> result{};
  std::array<std::uint32_t, 64> faces{};
  // Between two samples of which one is farther from the mesh than they are from each other lies no face.
  const double alike = step * (1 + 1e-9);
  for (std::size_t s = 0; s < result.size(); ++s) {
    const std::array<std::size_t, 3> index = {s & 3, s >> 2 & 3, s >> 4};
    const Vector3d point =
        first + step * Vector3d(static_cast<double>(index[0]), static_cast<double>(index[1]), static_cast<double>(index[2]));
    std::size_t axis = 0;
    while (axis < 2 && index[axis] == 0) ++axis;
    const Found found = nearest(point, on_face(point, s == 0 ? 0 : faces[s - kBack[axis]]));
    faces[s] = found.face;
    const double distance = std::sqrt(found.square);
    bool inside = false;
    if (!winding_) {
      inside = behind(found);
    } else {
      bool known = false;
      for (axis = 0; axis < 3 && !known; ++axis) {
        if (index[axis] == 0) continue;
        const double before = result[s - kBack[axis]];
        known = std::max(distance, std::abs(before)) > alike;
        inside = before < 0;
      }
      if (!known) inside = (*winding_)(point) > 0.5;
    }
    result[s] = inside ? -distance : distance;
  }
  return result;
}

}  // namespace isotouch::field
