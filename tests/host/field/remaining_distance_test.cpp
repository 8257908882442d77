#include "host/field/remaining_distance.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "host/field/sample_distance.h"
#include "tests/support/accuracy.h"

namespace isotouch::field {
namespace {

using Eigen::Vector3d;

const Vector3d kBall(20, 20, 20), kShard(20, 20, 36);
constexpr double kBallRadius = 11.0, kShardRadius = 2.5, kBand = 3.0;

double ball(const Vector3d& p) { return (p - kBall).norm() - kBallRadius; }
double shard(const Vector3d& p) { return (p - kShard).norm() - kShardRadius; }
Vector3d place(const Brick& brick, int s) { return (4 * brick.cell + Eigen::Vector3i(s & 3, s >> 2 & 3, s >> 4)).cast<double>(); }

/// A ball and a shard 2.5 voxels above it; the shard's samples are outside already, and taken.
struct WithoutShard {
  BandField field;
  std::vector<BrickMask> taken;

  WithoutShard() {
    Grid grid;
    grid.size = Eigen::Vector3i::Constant(48);
    field = sample_distance([](const Vector3d& p) { return std::min(ball(p), shard(p)); }, grid, kBand);
    for (Brick& brick : field.bricks) {
      taken.push_back(0);
      for (int s = 0; s < 64; ++s) {
        if (shard(place(brick, s)) >= 0.0) continue;
        taken.back() |= BrickMask{1} << s;
        brick.distance[static_cast<std::size_t>(s)] = 1.0F;
      }
    }
  }
};

TEST(RemainingDistance, IsThatToTheBallAloneWithinAFewPerCent) {
  WithoutShard without;
  restore_distances(without.field, without.taken);
  double largest = 0.0;
  std::size_t asked = 0;
  for (const Brick& brick : without.field.bricks) {
    for (int s = 0; s < 64; ++s) {
      const double truth = ball(place(brick, s)), found = static_cast<double>(brick.distance[static_cast<std::size_t>(s)]);
      ASSERT_EQ(found < 0.0, truth < 0.0);
      if (std::abs(truth) > kBand) continue;
      ++asked;
      EXPECT_LT(std::abs(found), std::abs(truth) + 0.06);
      largest = std::max(largest, std::abs(truth) - std::abs(found));  // as large as 3 where something is left of the shard
    }
  }
  EXPECT_GT(asked, 8000U);
  EXPECT_THAT(largest, test::IsAccuracyOf(0.3));
}

TEST(RemainingDistance, IsBeyondTheBandWhereNothingIsLeft) {
  WithoutShard without;
  restore_distances(without.field, without.taken);
  std::size_t asked = 0;
  for (const Brick& brick : without.field.bricks) {
    for (int s = 0; s < 64; ++s) {
      if (ball(place(brick, s)) < 1.1 * kBand) continue;
      ++asked;
      EXPECT_GT(brick.distance[static_cast<std::size_t>(s)], kBand);
    }
  }
  EXPECT_GT(asked, 500U);
}

TEST(RemainingDistance, OfAFieldOfWhichNothingWasTakenIsWhatItWas) {
  const WithoutShard before;
  BandField field = before.field;
  restore_distances(field, std::vector<BrickMask>(field.bricks.size(), 0));
  ASSERT_EQ(field.bricks.size(), before.field.bricks.size());
  for (std::size_t b = 0; b < field.bricks.size(); ++b) EXPECT_EQ(field.bricks[b].distance, before.field.bricks[b].distance);
}

}  // namespace
}  // namespace isotouch::field
