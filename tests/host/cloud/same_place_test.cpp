#include "host/cloud/same_place.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>
#include <vector>

#include "host/cloud/random.h"

namespace isotouch::cloud {
namespace {

using Eigen::Vector3d;

Vector3d random_in_cube(Random& random, double half) {
  return {random.uniform(-half, half), random.uniform(-half, half), random.uniform(-half, half)};
}

/// The middle half of them is about 1 wide, so that two points at one place are 1e-6 apart at most.
std::vector<Vector3d> in_cube(std::size_t count) {
  Random random(1);
  std::vector<Vector3d> points(count);
  for (Vector3d& p : points) p = random_in_cube(random, 1.0);
  return points;
}

TEST(SamePlace, TwinsAreFoundWhereverTheyLie) {
  std::vector<Vector3d> points = in_cube(2000);
  Random random(2);
  for (std::size_t i = 0; i < 2000; ++i) points.emplace_back(points[i] + random_in_cube(random, 5e-7));
  const std::vector<std::uint32_t> first = first_at_place(points);
  ASSERT_EQ(first.size(), 4000U);
  for (std::size_t i = 0; i < 2000; ++i) {
    EXPECT_EQ(first[i], i);
    EXPECT_EQ(first[2000 + i], i);
  }
}

TEST(SamePlace, PointsFartherApartStayApart) {
  std::vector<Vector3d> points = in_cube(2000);
  for (std::size_t i = 0; i < 2000; ++i) points.emplace_back(points[i] + 2e-6 * Vector3d::Unit(static_cast<Eigen::Index>(i % 3)));
  const std::vector<std::uint32_t> first = first_at_place(points);
  for (std::size_t i = 0; i < 4000; ++i) EXPECT_EQ(first[i], i);
}

TEST(SamePlace, APlaceDoesNotGrowAlongARow) {
  std::vector<Vector3d> points = in_cube(2000);
  for (int i = 0; i < 200; ++i) points.emplace_back(0.5, 0.5, 9e-7 * i);
  const std::vector<std::uint32_t> first = first_at_place(points);
  for (std::size_t i = 2000; i < points.size(); ++i) EXPECT_LT((points[i] - points[first[i]]).norm(), 4e-6);
}

TEST(SamePlace, WhereAllPointsAreAtOnePlaceEachPositionIsOne) {
  const std::vector<Vector3d> points = {{1, 2, 3}, {1, 2, 3}, {1, 2, 3}, {1, 2, 3}, {1, 2, 3}, {1, 2, 3.5}};
  EXPECT_EQ(first_at_place(points), (std::vector<std::uint32_t>{0, 0, 0, 0, 0, 5}));
}

}  // namespace
}  // namespace isotouch::cloud
