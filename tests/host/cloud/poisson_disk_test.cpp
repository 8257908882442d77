#include "host/cloud/poisson_disk.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "host/cloud/random.h"

namespace isotouch::cloud {
namespace {

using Eigen::Vector3d;

/// Random points on the unit square, all with one normal.
OrientedPoints square(std::size_t count) {
  Random random(4);
  OrientedPoints points;
  for (std::size_t i = 0; i < count; ++i) {
    const double x = random.uniform();
    points.positions.emplace_back(x, random.uniform(), 0.0);
    points.normals.emplace_back(0.0, 0.0, 1.0);
  }
  return points;
}

TEST(Elimination, KeepsExactlyAsManyAsAskedInAscendingOrder) {
  const auto kept = spread_out(square(1000), 1.0, 200);
  EXPECT_EQ(kept.size(), 200U);
  EXPECT_TRUE(std::is_sorted(kept.begin(), kept.end()));
  EXPECT_EQ(std::adjacent_find(kept.begin(), kept.end()), kept.end());
}

TEST(Elimination, KeepsAllWhereThereAreTooFew) { EXPECT_EQ(spread_out(square(5), 1.0, 8).size(), 5U); }

TEST(Elimination, RemovesThePointThatIsMostCrowded) {
  OrientedPoints points;
  for (const double x : {0.0, 1.0, 1.2, 1.4, 3.0}) {
    points.positions.emplace_back(x, 0.0, 0.0);
    points.normals.emplace_back(0.0, 0.0, 1.0);
  }
  const std::vector<std::size_t> expected = {0, 1, 3, 4};
  EXPECT_EQ(spread_out(points, 8.0, 4), expected);
}

TEST(Elimination, OppositeSidesDoNotCrowdEachOther) {
  OrientedPoints points = square(400);
  const OrientedPoints other = square(400);
  for (std::size_t i = 0; i < other.size(); ++i) {
    points.positions.push_back(other.positions[i]);
    points.normals.emplace_back(0.0, 0.0, -1.0);
  }
  const auto kept = spread_out(points, 2.0, 200);
  const auto above = static_cast<std::size_t>(std::count_if(kept.begin(), kept.end(), [](std::size_t i) { return i < 400; }));
  EXPECT_EQ(above, 100U);  // the sides are twins, so what is removed on one is removed on the other
}

}  // namespace
}  // namespace isotouch::cloud
