#include "host/field/unsupported_components.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "host/field/sample_distance.h"

namespace isotouch::field {
namespace {

using Eigen::Vector3d;

constexpr double kRadius = 13.0;
const Vector3d kMiddle = Vector3d::Constant(20);
const Vector3d kShard(20, 20, 37), kBubble(20, 20, 11);

/// A ball with a shard outside and a bubble inside, each of radius 1.5.
double distance(const Vector3d& p) {
  const double ball = std::max((p - kMiddle).norm() - kRadius, 1.5 - (p - kBubble).norm());
  return std::min(ball, (p - kShard).norm() - 1.5);
}

BandField field() {
  Grid grid;
  grid.size = Eigen::Vector3i::Constant(48);
  return sample_distance(distance, grid, 4.0);
}

/// Points of the ball, and `count` of the shard.
std::vector<Vector3d> points(int count) {
  std::vector<Vector3d> all;
  for (int n = 0; n < 40; ++n) all.push_back(kMiddle + kRadius * Vector3d(std::cos(n), std::sin(n), 0.0));
  for (int n = 0; n < count; ++n) all.push_back(kShard + 1.5 * Vector3d(std::cos(n), std::sin(n), 0.0));
  return all;
}

std::size_t inside(const BandField& field, const Vector3d& middle, double radius) {
  std::size_t count = 0;
  for (const Brick& brick : field.bricks) {
    for (int s = 0; s < 64; ++s) {
      const Vector3d p = (4 * brick.cell + Eigen::Vector3i(s & 3, s >> 2 & 3, s >> 4)).cast<double>();
      count += (p - middle).norm() <= radius && brick.distance[static_cast<std::size_t>(s)] < 0.0F;
    }
  }
  return count;
}

/// Samples on the wrong side of the ball alone.
std::size_t off_ball(const BandField& field) {
  std::size_t count = 0;
  for (const Brick& brick : field.bricks) {
    for (int s = 0; s < 64; ++s) {
      const Vector3d p = (4 * brick.cell + Eigen::Vector3i(s & 3, s >> 2 & 3, s >> 4)).cast<double>();
      count += (brick.distance[static_cast<std::size_t>(s)] < 0.0F) != ((p - kMiddle).norm() < kRadius) ? 1U : 0U;
    }
  }
  return count;
}

bool in_ball(const Vector3d& p) { return (p - kMiddle).norm() < kRadius; }
bool everywhere(const Vector3d&) { return true; }

TEST(DropDebris, DropsWhatNoPointStandsForAndLeavesTheBody) {
  const BandField before = field();
  BandField after = before;
  const UnsupportedComponents dropped = drop_unsupported(after, points(0), in_ball);
  EXPECT_EQ(dropped.pieces, 1U);
  EXPECT_EQ(dropped.cavities, 1U);
  EXPECT_GT(inside(before, kShard, 2.0), 5U);
  EXPECT_EQ(inside(after, kShard, 2.0), 0U);
  EXPECT_GT(off_ball(before), 10U);
  EXPECT_EQ(off_ball(after), 0U);
}

TEST(DropDebris, WhatADroppedPieceEnclosesGoesWithIt) {
  const auto hollow = [](const Vector3d& p) { return std::max((p - kMiddle).norm() - kRadius, 8.0 - (p - kMiddle).norm()); };
  Grid grid;
  grid.size = Eigen::Vector3i::Constant(48);
  BandField field = sample_distance(hollow, grid, 4.0);
  const UnsupportedComponents dropped = drop_unsupported(field, {}, everywhere);
  EXPECT_EQ(dropped.pieces, 1U);
  EXPECT_EQ(dropped.cavities, 1U);
  for (const Brick& brick : field.bricks) {
    EXPECT_TRUE(std::all_of(brick.distance.begin(), brick.distance.end(), [](float d) { return d > 4.0F; }));
  }
}

TEST(DropDebris, ACavityMayBeSoLargeThatNoBrickIsListedInItsMiddle) {
  const auto hollow = [](const Vector3d& p) { return std::max((p - kMiddle).norm() - kRadius, 8.0 - (p - kMiddle).norm()); };
  Grid grid;
  grid.size = Eigen::Vector3i::Constant(48);
  BandField field = sample_distance(hollow, grid, 2.0);
  ASSERT_TRUE(std::none_of(field.bricks.begin(), field.bricks.end(), [](const Brick& b) { return b.cell == Eigen::Vector3i(5, 5, 5); }));
  EXPECT_EQ(drop_unsupported(field, points(0), in_ball).cavities, 1U);
  EXPECT_EQ(off_ball(field), 0U);
}

TEST(DropDebris, ADipToZeroThatNoPointStandsForIsFilled) {
  // A sheet so thin that no sample lies in it.
  const auto sheet = [](const Vector3d& p) { return std::hypot(p.z() - 37.4, std::max(std::hypot(p.x() - 20, p.y() - 20) - 5.0, 0.0)); };
  Grid grid;
  grid.size = Eigen::Vector3i::Constant(48);
  const BandField before =
      sample_distance([&](const Vector3d& p) { return std::min((p - kMiddle).norm() - kRadius, sheet(p)); }, grid, 4.0);
  const auto least = [&](const BandField& field) {
    float smallest = 99;
    for (const Brick& brick : field.bricks) {
      for (int s = 0; s < 64; ++s) {
        const Vector3d p = (4 * brick.cell + Eigen::Vector3i(s & 3, s >> 2 & 3, s >> 4)).cast<double>();
        if (sheet(p) < 1.0) smallest = std::min(smallest, brick.distance[static_cast<std::size_t>(s)]);
      }
    }
    return smallest;
  };
  BandField after = before;
  drop_unsupported(after, points(0), in_ball);
  EXPECT_LT(least(before), 0.5F);
  EXPECT_GT(least(after), 3.0F);
  std::vector<Vector3d> on_sheet;
  for (int n = 0; n < 12; ++n) on_sheet.emplace_back(18 + n % 4, 18 + n / 4, 37.4);
  after = before;
  drop_unsupported(after, on_sheet, in_ball);
  EXPECT_EQ(least(after), least(before));
}

TEST(DropDebris, KeepsASmallPieceThatPointsStandFor) {
  BandField after = field();
  const std::size_t before = inside(after, kShard, 2.0);
  const UnsupportedComponents dropped = drop_unsupported(after, points(12), everywhere);
  EXPECT_EQ(dropped.pieces, 0U);
  EXPECT_EQ(inside(after, kShard, 2.0), before);
}

TEST(DropDebris, DropsAPieceOfFewPointsThatTheWholeScanContradicts) {
  BandField after = field();
  EXPECT_EQ(drop_unsupported(after, points(12), in_ball).pieces, 1U);
  EXPECT_EQ(inside(after, kShard, 2.0), 0U);
}

TEST(DropDebris, KeepsAPieceOfManyPointsWhateverTheOthersSay) {
  BandField after = field();
  const std::size_t before = inside(after, kShard, 2.0);
  EXPECT_EQ(drop_unsupported(after, points(80), in_ball).pieces, 0U);
  EXPECT_EQ(inside(after, kShard, 2.0), before);
}

}  // namespace
}  // namespace isotouch::field
