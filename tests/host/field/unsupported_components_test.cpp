#include "host/field/unsupported_components.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

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
  EXPECT_GT(inside(after, kBubble, 1.9), inside(before, kBubble, 1.9) + 5);
  std::size_t changed = 0;
  for (std::size_t b = 0; b < before.bricks.size(); ++b) {
    for (std::size_t s = 0; s < 64; ++s) changed += before.bricks[b].distance[s] != after.bricks[b].distance[s];
  }
  EXPECT_LT(changed, 120U);
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
