#include "host/field/empty_balls.h"

#include <gtest/gtest.h>

#include "host/field/balls.h"

namespace isotouch::field {
namespace {

using Eigen::Vector3d;

/// A wavy sheet with its exact normals.
cloud::OrientedPoints sheet() {
  cloud::OrientedPoints points;
  for (int i = 0; i < 20; ++i) {
    for (int j = 0; j < 20; ++j) {
      const double x = 0.5 * i, y = 0.5 * j, u = x - 4.75, v = y - 4.75;
      points.positions.emplace_back(x, y, (u * u - v * v) / 5.0);
      points.normals.push_back(Vector3d(-u / 2.5, v / 2.5, 1.0).normalized());
    }
  }
  return points;
}

TEST(EmptyBalls, HaveThePackingRadiusUpToTheirCap) {
  const auto points = sheet();
  const auto radii = packing_radii_brute_force(points);
  const auto balls = empty_balls(Scan(points));
  std::size_t below_cap = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    EXPECT_LE(balls[i].inner_radius, radii[i] * (1 + 1e-12));
    if (balls[i].inner_radius < 2.9) {
      EXPECT_NEAR(balls[i].inner_radius, radii[i], 1e-9 * radii[i]);
      ++below_cap;
    }
  }
  EXPECT_GT(below_cap, 0U);
  EXPECT_LT(below_cap, points.size());
}

TEST(EmptyBalls, HoldADistanceThatThreeOfThemContradict) {
  const auto points = sheet();
  const Scan scan(points);
  const auto balls = empty_balls(scan);
  std::vector<Neighbour> nearest;
  const Vector3d above(4.75, 4.75, 2.0), below(4.75, 4.75, -2.0);
  scan.tree().nearest(above, 8, nearest);
  EXPECT_GT(held_by_balls(-5.0, above, nearest, balls), 1.0);
  EXPECT_EQ(held_by_balls(2.0, above, nearest, balls), 2.0);
  scan.tree().nearest(below, 8, nearest);
  EXPECT_LT(held_by_balls(5.0, below, nearest, balls), -1.0);
  EXPECT_EQ(held_by_balls(5.0, below, std::span(nearest).first(2), balls), 5.0);
}

TEST(EmptyBalls, OneWrongNormalDecidesNothing) {
  auto points = sheet();
  const std::size_t middle = 9 * 20 + 9;
  points.normals[middle] = -points.normals[middle];
  const Scan scan(points);
  const auto balls = empty_balls(scan);
  std::vector<Neighbour> nearest;
  const Vector3d above(4.6, 4.6, 1.0);
  scan.tree().nearest(above, 8, nearest);
  EXPECT_EQ(held_by_balls(1.8, above, nearest, balls), 1.8);
}

}  // namespace
}  // namespace isotouch::field
