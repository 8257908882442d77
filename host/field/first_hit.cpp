#include "host/field/first_hit.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

namespace isotouch::field {
namespace {

constexpr double kNever = std::numeric_limits<double>::max();

/// Where the ray enters a box; kNever when it passes it.
double entry(const TriangleTree::Box& box, const Eigen::Vector3d& begin, const Eigen::Vector3d& inverse, double from, double to) {
  for (int a = 0; a < 3; ++a) {
    const double t0 = (box.low[a] - begin[a]) * inverse[a], t1 = (box.high[a] - begin[a]) * inverse[a];
    from = std::max(from, std::min(t0, t1));
    to = std::min(to, std::max(t0, t1));
  }
  return from <= to ? from : kNever;
}

}  // namespace

std::optional<FaceHit> first_hit(const TriangleTree& tree, const Eigen::Vector3d& from, const Eigen::Vector3d& direction, double begin) {
  const Eigen::Vector3d inverse = direction.unaryExpr([](double d) { return 1.0 / (std::fabs(d) > 1e-12 ? d : 1e-12); });
  double nearest = kNever;
  Eigen::Vector3d across = Eigen::Vector3d::Zero();
  std::array<std::pair<std::size_t, double>, 64> waiting;  // at most one a level
  std::size_t count = 0;
  const auto wait_for = [&](std::size_t node, double t) {
    if (t < nearest) waiting[count++] = {node, t};
  };
  const auto entry_of = [&](std::size_t node) {
    return tree.is_empty(node) ? kNever : entry(tree.box(node), from, inverse, begin, nearest);
  };
  wait_for(TriangleTree::root(), entry_of(TriangleTree::root()));
  while (count > 0) {
    const auto [node, t] = waiting[--count];
    if (t >= nearest) continue;
    if (!tree.is_leaf(node)) {
      std::pair<std::size_t, double> near{2 * node, entry_of(2 * node)}, far{2 * node + 1, entry_of(2 * node + 1)};
      if (far.second < near.second) std::swap(near, far);
      wait_for(far.first, far.second);
      wait_for(near.first, near.second);
      continue;
    }
    for (const std::uint32_t face : tree.faces(node)) {
      const auto [a, b, c] = tree.corners(face);
      const Eigen::Vector3d ab = b - a, ac = c - a, to = from - a, normal = ab.cross(ac);
      const double slope = -direction.dot(normal);
      if (slope == 0) continue;
      const Eigen::Vector3d turned = to.cross(direction);
      const double u = ac.dot(turned) / slope, v = -ab.dot(turned) / slope, t_face = to.dot(normal) / slope;
      if (u < 0 || v < 0 || u + v > 1 || t_face < begin || t_face >= nearest) continue;
      nearest = t_face;
      across = normal;
    }
  }
  if (nearest == kNever) return std::nullopt;
  return FaceHit{nearest, across.normalized(), across.dot(direction) > 0};
}

}  // namespace isotouch::field
