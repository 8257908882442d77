#include "host/evaluate/equal_answers.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <vector>

namespace isotouch::evaluate {

using Eigen::Vector3d;
using field::TriangleTree;

namespace {

constexpr double kSamePlace = 1e-7;  // mm

/// The place of one face that is nearest to the hand.
struct Nearest {
  Vector3d point;
  double distance;
  std::uint32_t face;
};

}  // namespace

bool has_equal_answer(const TriangleTree& tree, const Vector3d& hip, const Vector3d& place) {
  const Vector3d to_place = place - hip;
  const double depth = to_place.norm();
  const double tolerance = std::max(kEqualMm, kEqualShare * depth);
  const double reach = depth + tolerance;
  std::vector<Nearest> near;
  tree.visit([&](const TriangleTree::Box& box) { return box.squared_distance(hip) <= reach * reach; },
             [&](std::uint32_t face) {
               const Vector3d point = field::nearest_on_triangle(hip, tree.corners(face)).point;
               const double distance = (point - hip).norm();
               if (distance <= reach) near.push_back({point, distance, face});
             });
  const double same_direction = std::cos(kOtherDirectionDeg * std::numbers::pi / 180);
  const double other_side = std::cos(kOtherSideDeg * std::numbers::pi / 180);
  const auto is_other = [&](const Nearest& candidate) {
    const Vector3d way = candidate.point - hip;
    const double product = candidate.distance * depth, along = way.dot(to_place);
    if (std::fabs(candidate.distance - depth) > tolerance || along > same_direction * product || along < other_side * product) return false;
    const auto [a, b, c] = tree.corners(candidate.face);
    return (b - a).cross(c - a).dot(way) > 0;  // the hand is behind it
  };
  const auto is_rest = [&](const Nearest& candidate) {
    return std::none_of(near.begin(), near.end(), [&](const Nearest& other) {
      return other.distance < candidate.distance - kSamePlace &&
             (field::nearest_on_triangle(candidate.point, tree.corners(other.face)).point - candidate.point).norm() < kSamePlace;
    });
  };
  return std::any_of(near.begin(), near.end(), [&](const Nearest& candidate) { return is_other(candidate) && is_rest(candidate); });
}

}  // namespace isotouch::evaluate
