#include "host/evaluate/sharp_edges.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <numeric>
#include <tuple>
#include <utility>

#include "host/field/face_edges.h"

namespace isotouch::evaluate {

using Eigen::Vector3d;

namespace {

/// The same with one vertex at each place, the first one there.
cloud::TriangleMesh with_common_vertices(cloud::TriangleMesh mesh) {
  std::vector<std::uint32_t> order(mesh.vertices.size()), first(mesh.vertices.size());
  std::iota(order.begin(), order.end(), 0U);
  const auto key = [&](std::uint32_t v) { return std::tuple(mesh.vertices[v].x(), mesh.vertices[v].y(), mesh.vertices[v].z()); };
  std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) { return std::pair(key(a), a) < std::pair(key(b), b); });
  for (std::size_t i = 0; i < order.size(); ++i)
    first[order[i]] = i > 0 && key(order[i]) == key(order[i - 1]) ? first[order[i - 1]] : order[i];
  for (auto& face : mesh.faces)
    for (std::uint32_t& v : face) v = first[v];
  return mesh;
}

}  // namespace

std::vector<SharpEdge> sharp_edges(const cloud::TriangleMesh& of, double least_deg) {
  const cloud::TriangleMesh mesh = with_common_vertices(of);
  std::vector<SharpEdge> sharp;
  const std::vector<field::FaceEdge> sides = field::face_edges(mesh);
  for (std::size_t i = 0; i + 1 < sides.size(); ++i) {
    if (!sides[i].same_edge(sides[i + 1])) continue;
    const Vector3d first = cloud::face_normal(mesh, sides[i].face), second = cloud::face_normal(mesh, sides[i + 1].face);
    if (first.isZero() || second.isZero()) continue;
    const double turn = std::atan2(first.cross(second).norm(), first.dot(second)) * 180 / std::numbers::pi;
    if (turn < least_deg) continue;
    // The corner of the second face that is not on the edge lies below the first face at a convex edge.
    const auto& corners = mesh.faces[sides[i + 1].face];
    const std::uint32_t third = corners[0] ^ corners[1] ^ corners[2] ^ sides[i].low ^ sides[i].high;
    const bool convex = first.dot(mesh.vertices[third] - mesh.vertices[sides[i].low]) < 0;
    sharp.push_back({mesh.vertices[sides[i].low], mesh.vertices[sides[i].high], {first, second}, convex ? turn : -turn});
  }
  return sharp;
}

std::optional<EdgePlace> place_on_edges(const std::vector<SharpEdge>& edges, cloud::Random& random) {
  double length = 0;
  for (const SharpEdge& edge : edges) length += (edge.end - edge.begin).norm();
  if (!(length > 0)) return std::nullopt;
  double left = random.uniform() * length;
  for (const SharpEdge& edge : edges) {
    const double own = (edge.end - edge.begin).norm();
    if (left < own) return EdgePlace{edge, edge.begin + left / own * (edge.end - edge.begin)};
    left -= own;
  }
  return EdgePlace{edges.back(), edges.back().end};
}

}  // namespace isotouch::evaluate
