#include "tests/integration/wall_trials.h"

#include <gtest/gtest.h>

namespace isotouch::test {
namespace {

class WallsHeavy : public testing::TestWithParam<Interpolation> {};
INSTANTIATE_TEST_SUITE_P(Both, WallsHeavy, testing::Values(Interpolation::kSpline, Interpolation::kTrilinear));

TEST_P(WallsHeavy, NoneIsPassedInAMillionTicks) {
  const WallRun run = wall_trials(1'000'000, 7, {.interpolation = GetParam()});
  EXPECT_EQ(run.passed, 0U) << describe(run);
  EXPECT_GE(run.ticks, 1'000'000U);
  EXPECT_GT(run.touching, run.ticks / 10) << describe(run);
  EXPECT_GT(run.deepest_voxel, 0.2) << describe(run);
  EXPECT_LT(run.deepest_voxel, 0.5) << describe(run);
  EXPECT_GT(run.jumps, run.ticks / 500) << describe(run);
  EXPECT_GT(run.longest_voxel, 3.75) << describe(run);
  EXPECT_LT(run.longest_voxel, 6.0) << describe(run) << "; three steps of 1.25 along the surface, and onto it";
}

TEST_P(WallsHeavy, WallsTooThinForTheGridAreFoundToBePassed) {
  const WallRun run = wall_trials(100'000, 7, {.interpolation = GetParam(), .thinnest = 0.3, .thickest = 0.5});
  EXPECT_GT(run.passed, 2U) << describe(run);
  EXPECT_FALSE(run.first.empty());
}

}  // namespace
}  // namespace isotouch::test
