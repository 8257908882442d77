#include "host/evaluate/mesh_distance.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <utility>

namespace isotouch::evaluate {

using Eigen::Vector3d;

namespace {

constexpr std::uint32_t kLeafFaces = 4;

/// Where on a triangle the nearest point lies: 0 to 2 its corners, 3 to 5 its edges (corner 0 to 1, 1 to 2, 2 to 0), 6 its face.
struct Nearest {
  Vector3d point;
  int feature;
};

/// By the regions of the triangle's plane, corners first, then edges.
Nearest nearest_on_triangle(const Vector3d& p, const Vector3d& a, const Vector3d& b, const Vector3d& c) {
  const Vector3d ab = b - a;
  const Vector3d ac = c - a;
  const double d1 = ab.dot(p - a);
  const double d2 = ac.dot(p - a);
  if (d1 <= 0 && d2 <= 0) return {a, 0};
  const double d3 = ab.dot(p - b);
  const double d4 = ac.dot(p - b);
  if (d3 >= 0 && d4 <= d3) return {b, 1};
  const double d5 = ab.dot(p - c);
  const double d6 = ac.dot(p - c);
  if (d6 >= 0 && d5 <= d6) return {c, 2};
  const double vc = d1 * d4 - d3 * d2;
  if (vc <= 0 && d1 >= 0 && d3 <= 0) return {a + d1 / (d1 - d3) * ab, 3};
  const double va = d3 * d6 - d5 * d4;
  if (va <= 0 && d4 - d3 >= 0 && d5 - d6 >= 0) return {b + (d4 - d3) / ((d4 - d3) + (d5 - d6)) * (c - b), 4};
  const double vb = d5 * d2 - d1 * d6;
  if (vb <= 0 && d2 >= 0 && d6 <= 0) return {a + d2 / (d2 - d6) * ac, 5};
  const double scale = 1 / (va + vb + vc);
  return {a + vb * scale * ab + vc * scale * ac, 6};
}

double angle_at(const Vector3d& corner, const Vector3d& b, const Vector3d& c) {
  const Vector3d u = b - corner;
  const Vector3d v = c - corner;
  return std::atan2(u.cross(v).norm(), u.dot(v));
}

}  // namespace

MeshDistance::MeshDistance(cloud::TriangleMesh mesh) : mesh_(std::move(mesh)), order_(mesh_.faces.size()) {
  std::iota(order_.begin(), order_.end(), 0U);
  nodes_.reserve(mesh_.faces.size());
  build(0, static_cast<std::uint32_t>(order_.size()));
  make_pseudonormals();
}

std::uint32_t MeshDistance::build(std::uint32_t first, std::uint32_t count) {
  const auto number = static_cast<std::uint32_t>(nodes_.size());
  Node node{Vector3d::Constant(std::numeric_limits<double>::max()), Vector3d::Constant(std::numeric_limits<double>::lowest())};
  for (std::uint32_t i = first; i < first + count; ++i) {
    for (const std::uint32_t v : mesh_.faces[order_[i]]) {
      node.low = node.low.cwiseMin(mesh_.vertices[v]);
      node.high = node.high.cwiseMax(mesh_.vertices[v]);
    }
  }
  nodes_.push_back(node);
  if (count <= kLeafFaces) {
    nodes_[number].first = first;
    nodes_[number].count = count;
    return number;
  }
  int axis = 0;
  (node.high - node.low).maxCoeff(&axis);
  const auto middle = [&](std::uint32_t face) {
    const auto& f = mesh_.faces[face];
    return mesh_.vertices[f[0]][axis] + mesh_.vertices[f[1]][axis] + mesh_.vertices[f[2]][axis];
  };
  const auto begin = order_.begin() + first;
  const std::uint32_t half = count / 2;
  std::nth_element(begin, begin + half, begin + count,
                   [&](std::uint32_t a, std::uint32_t b) { return std::pair(middle(a), a) < std::pair(middle(b), b); });
  build(first, half);
  const std::uint32_t right = build(first + half, count - half);
  nodes_[number].right = right;
  return number;
}

void MeshDistance::make_pseudonormals() {
  vertex_normals_.assign(mesh_.vertices.size(), Vector3d::Zero());
  edge_normals_.resize(mesh_.faces.size());
  std::map<std::pair<std::uint32_t, std::uint32_t>, Vector3d> edges;
  const auto edge = [](std::uint32_t a, std::uint32_t b) { return std::pair(std::min(a, b), std::max(a, b)); };
  for (std::size_t face = 0; face < mesh_.faces.size(); ++face) {
    const Vector3d normal = cloud::face_normal(mesh_, face);
    face_normals_.push_back(normal);
    const auto& f = mesh_.faces[face];
    for (std::size_t i = 0; i < 3; ++i) {
      const std::uint32_t here = f[i];
      const std::uint32_t next = f[(i + 1) % 3];
      const std::uint32_t last = f[(i + 2) % 3];
      vertex_normals_[here] += angle_at(mesh_.vertices[here], mesh_.vertices[next], mesh_.vertices[last]) * normal;
      edges.try_emplace(edge(here, next), Vector3d::Zero()).first->second += normal;
    }
  }
  for (std::size_t face = 0; face < mesh_.faces.size(); ++face) {
    const auto& f = mesh_.faces[face];
    for (std::size_t i = 0; i < 3; ++i) edge_normals_[face][i] = edges.at(edge(f[i], f[(i + 1) % 3]));
  }
}

double MeshDistance::operator()(const Vector3d& point) const {
  const auto square_to_box = [&](const Node& node) { return (node.low - point).cwiseMax(point - node.high).cwiseMax(0).squaredNorm(); };
  double best = std::numeric_limits<double>::max();
  Vector3d offset = Vector3d::Zero();
  Vector3d normal = Vector3d::Zero();
  std::array<std::pair<std::uint32_t, double>, 64> waiting;  // a median split halves: 32 levels hold every mesh
  std::size_t count = 0;
  waiting[count++] = {0, square_to_box(nodes_[0])};
  while (count > 0) {
    const auto [number, square] = waiting[--count];
    if (square >= best) continue;
    const Node& node = nodes_[number];
    if (node.count == 0) {
      std::pair<std::uint32_t, double> near{number + 1, square_to_box(nodes_[number + 1])};
      std::pair<std::uint32_t, double> far{node.right, square_to_box(nodes_[node.right])};
      if (far.second < near.second) std::swap(near, far);
      waiting[count++] = far;
      waiting[count++] = near;
      continue;
    }
    for (std::uint32_t i = node.first; i < node.first + node.count; ++i) {
      const std::uint32_t face = order_[i];
      const auto& f = mesh_.faces[face];
      const Nearest found = nearest_on_triangle(point, mesh_.vertices[f[0]], mesh_.vertices[f[1]], mesh_.vertices[f[2]]);
      const double distance = (point - found.point).squaredNorm();
      if (distance >= best) continue;
      best = distance;
      offset = point - found.point;
      const auto feature = static_cast<std::size_t>(found.feature);
      normal = feature < 3 ? vertex_normals_[f[feature]] : feature < 6 ? edge_normals_[face][feature - 3] : face_normals_[face];
    }
  }
  return offset.dot(normal) < 0 ? -std::sqrt(best) : std::sqrt(best);
}

}  // namespace isotouch::evaluate
