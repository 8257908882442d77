#include "host/evaluate/sharp_edges.h"

#include <Eigen/Geometry>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>

#include "host/field/face_edges.h"

namespace isotouch::evaluate {

using Eigen::Vector3d;

std::vector<SharpEdge> sharp_edges(const cloud::TriangleMesh& mesh, double least_deg) {
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
