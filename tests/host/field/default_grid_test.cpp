#include "host/field/default_grid.h"

#include <gtest/gtest.h>

namespace isotouch::field {
namespace {

const Eigen::Vector3d kFlat(70, 40, 20), kCube(70, 70, 70);

TEST(DefaultGrid, HasTwoVoxelsBetweenPointsWithinItsEnds) {
  EXPECT_EQ(default_grid(kFlat, 1.3), 186) << "a scan of some 4,000 points";
  EXPECT_EQ(default_grid(kFlat, 0.5), 280);
  EXPECT_EQ(default_grid(kFlat, 0.1), 372);
  EXPECT_EQ(default_grid(kFlat / 1024, 0.5 / 1024), 280) << "whatever the unit";
}

TEST(DefaultGrid, OfAMeshIsFineUnlessItWouldNotFitAController) {
  EXPECT_EQ(default_grid(kFlat, 0), 372);
  const int cube = default_grid(kCube, 0);
  EXPECT_LT(6.0 * cube * cube * kBytesPerSquareVoxel, 16 << 20);
  EXPECT_GT(6.0 * cube * cube * kBytesPerSquareVoxel, 12 << 19);
  EXPECT_EQ(default_grid({70, 0, 0}, 0), 372) << "a line";
}

TEST(DefaultGrid, IsNeverUseless) {
  for (const double spacing : {0.1, 0.5, 1.0, 1.3, 2.0}) EXPECT_LE(default_grid(kFlat, spacing), finest_grid(70, spacing)) << spacing;
  EXPECT_EQ(finest_grid(70, 1.4), 300);
  EXPECT_EQ(finest_grid(1e9, 1e-9), 1'000'000);
}

}  // namespace
}  // namespace isotouch::field
