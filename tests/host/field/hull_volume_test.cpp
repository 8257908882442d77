#include "host/field/hull_volume.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <vector>

#include "host/cloud/random.h"
#include "host/field/orientation.h"

namespace isotouch::field {
namespace {

using Eigen::Vector3d;

std::vector<Vector3d> scattered(std::size_t count) {
  cloud::Random random(11);
  std::vector<Vector3d> points;
  for (std::size_t i = 0; i < count; ++i) {
    const double x = random.uniform(-3, 5), y = random.uniform(0, 2), z = random.uniform(-1, 1);
    points.emplace_back(x, y + 0.3 * x, z - 0.2 * y);
  }
  return points;
}

/// Of 40 x 40 x 40 cells, each asked by itself.
double by_every_cell(const std::vector<Vector3d>& points) {
  Vector3d low = points[0], high = points[0];
  for (const Vector3d& p : points) low = low.cwiseMin(p), high = high.cwiseMax(p);
  const Vector3d cell = (high - low) / 40;
  std::size_t held = 0;
  for (int n = 0; n < 40 * 40 * 40; ++n) {
    const Vector3d middle = low + cell.cwiseProduct(Vector3d(n % 40 + 0.5, n / 40 % 40 + 0.5, n / 1600 + 0.5));
    bool inside = true;
    for (const Vector3d& direction : half_directions()) {
      const auto nearer = [&](const Vector3d& a, const Vector3d& b) { return direction.dot(a) < direction.dot(b); };
      const auto [least, most] = std::minmax_element(points.begin(), points.end(), nearer);
      inside = inside && direction.dot(middle) >= direction.dot(*least) && direction.dot(middle) <= direction.dot(*most);
      if (!inside) break;
    }
    held += inside ? 1U : 0U;
  }
  return static_cast<double>(held) * cell.prod();
}

TEST(HullVolume, CountsTheCellsThatEveryHalfSpaceHolds) {
  for (const std::size_t count : {4U, 9U, 30U}) {
    const std::vector<Vector3d> points = scattered(count);
    EXPECT_EQ(hull_volume(points), by_every_cell(points)) << count;
  }
}

TEST(HullVolume, OfABoxIsItsVolume) {
  std::vector<Vector3d> corners;
  for (int n = 0; n < 8; ++n) corners.emplace_back(2.0 * (n & 1), 3.0 * (n >> 1 & 1), 4.0 * (n >> 2));
  EXPECT_NEAR(hull_volume(corners), 24.0, 1e-9);
}

TEST(HullVolume, OfFlatPointsIsNothing) {
  EXPECT_EQ(hull_volume({{0, 0, 1}, {1, 0, 1}, {0, 1, 1}, {1, 1, 1}}), 0.0);
  EXPECT_EQ(hull_volume({{2, 2, 2}}), 0.0);
}

}  // namespace
}  // namespace isotouch::field
