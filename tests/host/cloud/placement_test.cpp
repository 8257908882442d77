#include "host/cloud/placement.h"

#include <gtest/gtest.h>

#include "host/error.h"

namespace isotouch::cloud {
namespace {

using Eigen::Vector3d;

OrientedPoints two_corners() { return {{Vector3d(1, 2, 3), Vector3d(5, 4, 4)}, {Vector3d(0, 0, 1), Vector3d(0, 1, 0)}}; }

TEST(Placement, FitsTheLongestSideTo70MmAndCentresTheBox) {
  const Placement placement = place(two_corners().positions);
  const OrientedPoints moved = placed(two_corners(), placement);
  EXPECT_DOUBLE_EQ(placement.scale, 17.5);
  EXPECT_LT((moved.positions[0] - Vector3d(-35, -17.5, -8.75)).norm(), 1e-12);
  EXPECT_LT((moved.positions[1] - Vector3d(35, 17.5, 8.75)).norm(), 1e-12);
  EXPECT_EQ(moved.normals[1], Vector3d(0, 1, 0));
  EXPECT_LT((placement.to_cloud(moved.positions[0]) - Vector3d(1, 2, 3)).norm(), 1e-12);
}

TEST(Placement, KnownUnitsKeepTheTrueSizeAndAreCentredToo) {
  const Placement placement = place(two_corners().positions, {.mm_per_unit = mm_per_unit("cm")});
  EXPECT_DOUBLE_EQ(placement.scale, 10.0);
  EXPECT_EQ(placement.to_workspace(Vector3d(3, 3, 3.5)), Vector3d::Zero());
}

TEST(Placement, KnowsFourUnits) {
  EXPECT_EQ(mm_per_unit("mm"), 1.0);
  EXPECT_EQ(mm_per_unit("m"), 1000.0);
  EXPECT_EQ(mm_per_unit("in"), 25.4);
  EXPECT_THROW(mm_per_unit("km"), InputError);
}

TEST(Placement, SizesThatNoWorkspaceHoldsAreRefused) {
  EXPECT_THROW(place(two_corners().positions, {.mm_per_unit = 1000.0}), InputError);
  EXPECT_THROW(place(two_corners().positions, {.mm_per_unit = 0.01}), InputError);
  EXPECT_THROW(place(two_corners().positions, {.mm_per_unit = {}, .fit_mm = -5.0}), InputError);
  EXPECT_THROW(place(two_corners().positions, {.mm_per_unit = {}, .fit_mm = 0.0}), InputError);
}

}  // namespace
}  // namespace isotouch::cloud
