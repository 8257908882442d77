#include "host/field/bricks.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <tuple>

namespace isotouch::field {
namespace {

using Eigen::Vector3d;
using Eigen::Vector3i;

const Vector3i kCells(14, 15, 16);
constexpr double kBand = 4.0;

double ball(const Vector3d& x) { return (x - Vector3d(27, 28, 31)).norm() - 17.3; }

std::array<float, 64> at_brick(const Vector3i& cell) {
  std::array<float, 64> d{};
  for (int s = 0; s < 64; ++s) {
    d[static_cast<std::size_t>(s)] = static_cast<float>(ball((4 * cell + Vector3i(s & 3, s >> 2 & 3, s >> 4)).cast<double>()));
  }
  return d;
}

BrickDistances brick_of_ball(const Vector3i& cell, double reach) {
  BrickDistances found{ball(4.0 * cell.cast<double>() + Vector3d::Constant(1.5)), {}};
  if (std::abs(found.middle) <= reach) found.samples = at_brick(cell);
  return found;
}

std::tuple<int, int, int> place(const Vector3i& cell) { return {cell.z(), cell.y(), cell.x()}; }

std::vector<Brick> walk(const std::vector<Vector3i>& seeds) { return band_bricks({ball, brick_of_ball}, kCells, kBand, seeds); }

TEST(BandBricks, FromOneSeedAreAllBricksOfTheBand) {
  const auto bricks = walk({{27 / 4, 28 / 4, (31 + 17) / 4}});
  std::set<std::tuple<int, int, int>> found;
  for (const auto& brick : bricks) found.insert(place(brick.cell));
  std::size_t wanted = 0;
  for (int z = 0; z < kCells.z(); ++z) {
    for (int y = 0; y < kCells.y(); ++y) {
      for (int x = 0; x < kCells.x(); ++x) {
        bool in_band = false;
        for (const float d : at_brick({x, y, z})) in_band = in_band || static_cast<double>(std::abs(d)) <= kBand;
        wanted += in_band;
        EXPECT_EQ(found.count({z, y, x}), in_band ? 1U : 0U) << x << ' ' << y << ' ' << z;
      }
    }
  }
  EXPECT_GT(wanted, 300U);
}

TEST(BandBricks, AreSortedAndHoldTheirSamples) {
  const auto bricks = walk({{27 / 4, 28 / 4, (31 + 17) / 4}, {-1, 0, 0}, {99, 0, 0}});
  for (std::size_t b = 1; b < bricks.size(); ++b) EXPECT_LT(place(bricks[b - 1].cell), place(bricks[b].cell));
  for (const auto& brick : bricks) {
    const auto exact = at_brick(brick.cell);
    for (std::size_t s = 0; s < 64; ++s) EXPECT_EQ(brick.distance[s], static_cast<float>(exact[s]));
  }
}

TEST(BandBricks, DoNotDependOnTheSeeds) {
  const auto one = walk({{27 / 4, 28 / 4, (31 + 17) / 4}});
  const auto many = walk({{27 / 4, (28 - 17) / 4, 31 / 4}, {(27 + 17) / 4, 28 / 4, 31 / 4}, {27 / 4, (28 - 17) / 4, 31 / 4}});
  ASSERT_EQ(one.size(), many.size());
  for (std::size_t b = 0; b < one.size(); ++b) EXPECT_EQ(place(one[b].cell), place(many[b].cell));
}

TEST(BandBricks, WithoutASeedAreNone) { EXPECT_TRUE(walk({}).empty()); }

}  // namespace
}  // namespace isotouch::field
