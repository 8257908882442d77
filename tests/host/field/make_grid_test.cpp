#include "host/field/make_grid.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "host/error.h"

namespace isotouch::field {
namespace {

using Eigen::Vector3d;

constexpr double kStep = 1.0 / (1 << 20);  // of the numbers that a field holds

TEST(MakeGrid, TheMarginIsThereOnEverySideAndTheBoxInTheMiddle) {
  const Vector3d low(-10, 3, 0.1), high(20.3, 9, 0.2);
  const double edge = 0.7;
  const Grid grid = make_grid(low, high, edge, 4);
  EXPECT_NEAR(grid.edge, edge, kStep);
  const Vector3d last = grid.position(grid.size - Eigen::Vector3i::Ones());
  for (int axis = 0; axis < 3; ++axis) {
    const double before = (low[axis] - grid.origin[axis]) / grid.edge, after = (last[axis] - high[axis]) / grid.edge;
    EXPECT_NEAR(before, after, 1e-5) << axis;
    EXPECT_GE(before, 4 - 1e-5) << axis;
    EXPECT_LT(before, 4.5 + 1e-5) << axis;
    EXPECT_EQ(grid.origin[axis] / kStep, std::floor(grid.origin[axis] / kStep)) << axis;
  }
  EXPECT_EQ(grid.edge / kStep, std::floor(grid.edge / kStep));
}

TEST(MakeGrid, VoxelsAreOfTheSizesThatAFieldHolds) {
  const auto make = [](double edge) { return make_grid(Vector3d::Zero(), Vector3d::Constant(20), edge, 4); };
  for (const double edge : {1.0 / 64, 16.0}) EXPECT_EQ(make(edge).edge, edge);
  for (const double edge : {1.0 / 64 - kStep, 16 + kStep, 0.0, -1.0, std::numeric_limits<double>::quiet_NaN()})
    EXPECT_THROW((void)make(edge), InputError) << edge;
}

TEST(MakeGrid, AnAxisHasNoMoreSamplesThanAFieldHolds) {
  for (int axis = 0; axis < 3; ++axis) {
    const auto make = [&](double length) { return make_grid(Vector3d::Zero(), length * Vector3d::Unit(axis), 1, 4); };
    EXPECT_EQ(make(4096 - 1 - 8).size[axis], 4096);
    EXPECT_THROW((void)make(4096 - 8), InputError) << axis;
  }
}

TEST(ExactGrid, IsTheNearestThatAFieldHolds) {
  Grid grid;
  grid.edge = 0.25 + 0.4 * kStep;
  grid.origin = Vector3d(-3 - 0.4 * kStep, 0.6 * kStep, 1);
  grid.size = {5, 6, 7};
  const Grid exact = exact_grid(grid);
  EXPECT_EQ(exact.edge, 0.25);
  EXPECT_EQ(exact.origin, Vector3d(-3, kStep, 1));
  EXPECT_EQ(exact.size, grid.size);
}

}  // namespace
}  // namespace isotouch::field
