#include "host/field/empty_balls.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "host/field/parallel.h"

namespace isotouch::field {

namespace {

constexpr std::size_t kSpacingOf = 4;  // a sample's spacing is the distance to its fourth neighbour
constexpr double kSlack = 0.5;         // spacings: balls of a thin plate reach through it by 0.4
constexpr std::size_t kVoices = 3;

/// The radius of the largest ball up to `cap` that touches the surface at sample i on the side of `normal` and holds no other sample.
double radius(const Scan& scan, std::size_t i, const Eigen::Vector3d& normal, double cap, std::vector<Neighbour>& found) {
  const Eigen::Vector3d& own = scan.positions()[i];
  double least = cap;
  const auto shrink_to = [&](std::span<const Neighbour> samples) {
    for (const Neighbour& j : samples) {
      const Eigen::Vector3d a = scan.positions()[j.index] - own;
      const double height = normal.dot(a);
      if (height > 0.0) least = std::min(least, a.squaredNorm() / (2.0 * height));
    }
  };
  shrink_to(scan.around(i));
  scan.tree().within_in_any_order(own + least * normal, least, found);
  shrink_to(found);
  return least;
}

}  // namespace

std::vector<EmptyBalls> empty_balls(const Scan& scan) {
  std::vector<EmptyBalls> balls(scan.size());
  in_parallel(scan.size(), 64, [&](std::size_t begin, std::size_t end) {
    std::vector<Neighbour> found;
    for (const std::uint32_t i : scan.together(begin, end)) {
      const auto around = scan.around(i);
      const double spacing = std::sqrt(around[std::min(kSpacingOf, around.size() - 1)].squared_distance);
      const Eigen::Vector3d &p = scan.positions()[i], &n = scan.normals()[i];
      EmptyBalls& ball = balls[i];
      ball.slack = kSlack * spacing;
      ball.outer_radius = radius(scan, i, n, kBallCap * spacing, found);
      ball.inner_radius = radius(scan, i, -n, kBallCap * spacing, found);
      ball.outer = p + ball.outer_radius * n;
      ball.inner = p - ball.inner_radius * n;
    }
  });
  return balls;
}

double held_by_balls(double distance, const Eigen::Vector3d& x, std::span<const Neighbour> nearest, const std::vector<EmptyBalls>& balls) {
  if (nearest.size() < kVoices) return distance;
  const bool inside = distance < 0.0;
  std::array<double, kVoices> deepest;  // how deep x lies in balls of the other side, the deepest first
  deepest.fill(-std::numeric_limits<double>::infinity());
  for (const Neighbour& n : nearest) {
    const EmptyBalls& ball = balls[n.index];
    double depth = (inside ? ball.outer_radius - (x - ball.outer).norm() : ball.inner_radius - (x - ball.inner).norm()) - ball.slack;
    for (double& place : deepest) {
      if (depth > place) std::swap(depth, place);
    }
  }
  const double agreed = deepest.back();
  return agreed <= 0.0 ? distance : inside ? std::max(distance, agreed) : std::min(distance, -agreed);
}

}  // namespace isotouch::field
