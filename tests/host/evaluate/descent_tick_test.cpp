#include "host/evaluate/descent_tick.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace isotouch::evaluate {
namespace {

using published::kDeepestLevel;
using published::kOutsideLevel;
using published::LevelField;

constexpr float kEdge = 0.5F;

/// A half-space: outside above node 10 along z, one level a node below.
LevelField floor_levels() {
  field::Grid grid;
  grid.edge = 0.5;
  grid.size = {24, 24, 16};
  grid.origin = {-6, -6, -5};  // node 10 lies at z = 0
  LevelField levels(grid, kOutsideLevel);
  for (int k = 0; k <= 10; ++k) {
    for (int j = 0; j < 24; ++j) {
      for (int i = 0; i < 24; ++i) levels.at(i, j, k) = static_cast<std::int8_t>(std::max(k - 10, kDeepestLevel));
    }
  }
  return levels;
}

TEST(DescentTick, LevelAndGradientAreThoseOfTheNodesAtTheNodes) {
  const LevelField levels = floor_levels();
  for (int k = 1; k < 14; ++k) {
    const LevelSample sample = sample_levels(levels, {5, 6, static_cast<float>(k)});
    EXPECT_EQ(sample.level, static_cast<float>(levels.at(5, 6, k)));
    EXPECT_EQ(sample.gradient.z(), 0.5F * static_cast<float>(levels.at(5, 6, k + 1) - levels.at(5, 6, k - 1)));
    EXPECT_EQ(sample.gradient.x(), 0.0F);
  }
}

TEST(DescentTick, NoContactGivesNoForceAndTheProxyIsTheHand) {
  const LevelField levels = floor_levels();
  DescentTick tick(levels, 0.8F);
  const Eigen::Vector3f hand(0.1F, 0.2F, 0.3F);
  EXPECT_EQ(tick.force(hand), Eigen::Vector3f::Zero());
  EXPECT_TRUE(tick.proxy().isApprox(hand, 1e-5F));
}

TEST(DescentTick, BeyondTheGridThereIsNoContact) {
  const LevelField levels = floor_levels();
  DescentTick tick(levels, 0.8F);
  EXPECT_EQ(tick.force({0, 0, -100}), Eigen::Vector3f::Zero());
  EXPECT_EQ(tick.force({std::numeric_limits<float>::quiet_NaN(), 0, 0}), Eigen::Vector3f::Zero());
}

TEST(DescentTick, OnAPlaneTheForceIsShortByOnePartInOnePlusLambda) {
  const LevelField levels = floor_levels();
  DescentTick tick(levels, 0.8F);
  for (const float depth : {1.5F, 3.0F, 4.0F}) {  // voxels
    tick.force({0, 0, 1});
    const Eigen::Vector3f force = tick.force({0, 0, -depth * kEdge});
    EXPECT_NEAR(force.z(), 0.8F * kEdge * depth * 10 / 11, 1e-4F);
    EXPECT_NEAR(force.x(), 0.0F, 1e-6F);
  }
}

TEST(DescentTick, OneTickTakesAway99PercentOfASidewaysMove) {
  const LevelField levels = floor_levels();
  DescentTick tick(levels, 0.8F);
  tick.force({0, 0, 1});
  tick.force({0, 0, -1});
  const float moved = 0.5F;
  tick.force({moved, 0, -1});
  EXPECT_NEAR(1 - tick.proxy().x() / moved, 0.0092F, 0.0005F);  // (30/31)^143
}

TEST(DescentTick, TheStepIsStableWhereALevelCountsManhattanDistance) {
  LevelField levels = floor_levels();  // now a slope along (1, 1, 1): every node a level below its upper neighbours
  for (int k = 0; k < 16; ++k) {
    for (int j = 0; j < 24; ++j) {
      for (int i = 0; i < 24; ++i) levels.at(i, j, k) = static_cast<std::int8_t>(std::max(i + j + k - 30, kDeepestLevel));
    }
  }
  const Eigen::Vector3f start = levels.grid.origin.cast<float>() + kEdge * Eigen::Vector3f(11, 11, 10);
  const Eigen::Vector3f hand = levels.grid.origin.cast<float>() + kEdge * Eigen::Vector3f(9, 9, 8);  // four levels deep, 4/√3 voxels
  DescentTick tick(levels, 1.0F);
  tick.force(start);
  const Eigen::Vector3f force = tick.force(hand);
  EXPECT_NEAR(force.norm(), kEdge * 4 / std::sqrt(3.0F) * 30 / 31, 1e-3F);
  EXPECT_NEAR(force.normalized().sum(), std::sqrt(3.0F), 1e-5F);
}

}  // namespace
}  // namespace isotouch::evaluate
