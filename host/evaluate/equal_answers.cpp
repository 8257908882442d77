#include "host/evaluate/equal_answers.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cstdint>

#include "host/angle.h"

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

std::vector<Vector3d> other_answers(const TriangleTree& tree, const Vector3d& hip, const Vector3d& place, double nearest, double farthest) {
  const Vector3d to_place = place - hip;
  std::vector<Nearest> near;
  tree.visit([&](const TriangleTree::Box& box) { return box.squared_distance(hip) <= farthest * farthest; },
             [&](std::uint32_t face) {
               const Vector3d point = field::nearest_on_triangle(hip, tree.corners(face)).point;
               const double distance = (point - hip).norm();
               if (distance <= farthest) near.push_back({point, distance, face});
             });
  const auto is_other = [&](const Nearest& candidate) {
    const Vector3d way = candidate.point - hip;
    const double angle = angle_deg(way, to_place);
    if (candidate.distance < nearest || angle < kOtherDirectionDeg || angle > kOtherSideDeg) return false;
    const auto [a, b, c] = tree.corners(candidate.face);
    return (b - a).cross(c - a).dot(way) > 0;  // the hand is behind it
  };
  const auto is_rest = [&](const Nearest& candidate) {
    return std::none_of(near.begin(), near.end(), [&](const Nearest& other) {
      return other.distance < candidate.distance - kSamePlace &&
             (field::nearest_on_triangle(candidate.point, tree.corners(other.face)).point - candidate.point).norm() < kSamePlace;
    });
  };
  std::vector<Vector3d> ways;
  for (const Nearest& candidate : near) {
    if (is_other(candidate) && is_rest(candidate)) ways.emplace_back(candidate.point - hip);
  }
  return ways;
}

}  // namespace isotouch::evaluate
