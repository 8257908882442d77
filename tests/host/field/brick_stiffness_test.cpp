#include "host/field/brick_stiffness.h"

#include <gtest/gtest.h>

#include <vector>

#include "host/cloud/random.h"

namespace isotouch::field {
namespace {

using Eigen::Vector3d;

struct Sheet {
  std::vector<Vector3d> positions;
  std::vector<double> stiffness;
};

/// A square of 48 voxels at z = 1.5 whose right half is stiffer; bricks of three layers around it.
Sheet two_halves() {
  Sheet sheet;
  cloud::Random random(9);
  for (int i = 0; i < 1500; ++i) {
    const double x = 48.0 * random.uniform();
    sheet.positions.emplace_back(x, 48.0 * random.uniform(), 1.5);
    sheet.stiffness.push_back(x < 24.0 ? 0.4 : 1.2);
  }
  return sheet;
}

std::vector<Brick> bricks_around() {
  std::vector<Brick> bricks;
  for (int z = -1; z <= 1; ++z) {
    for (int y = 0; y < 12; ++y) {
      for (int x = 0; x < 12; ++x) bricks.push_back({{x, y, z}, {}});
    }
  }
  return bricks;
}

TEST(BrickStiffness, FollowsTheSamplesNearEachBrick) {
  const Sheet sheet = two_halves();
  const std::vector<Brick> bricks = bricks_around();
  const std::vector<double> found = brick_stiffness(bricks, sheet.stiffness, Nearest(sheet.positions));
  ASSERT_EQ(found.size(), bricks.size());
  int between = 0;
  for (std::size_t b = 0; b < bricks.size(); ++b) {
    const int x = bricks[b].cell.x();
    if (x < 4) {
      EXPECT_EQ(found[b], 0.4);
    } else if (x > 7) {
      EXPECT_EQ(found[b], 1.2);
    }
    EXPECT_GE(found[b], 0.4);
    EXPECT_LE(found[b], 1.2);
    between += found[b] > 0.401 && found[b] < 1.199 ? 1 : 0;
  }
  EXPECT_GT(between, 0);
}

TEST(BrickStiffness, ANearerSampleCountsMore) {
  const std::vector<Vector3d> places = {{1.5, 1.5, 0.5}, {1.5, 1.5, 4.5}};
  const std::vector<double> found = brick_stiffness({{{0, 0, 0}, {}}}, {1.0, 2.0}, Nearest(places));
  EXPECT_NEAR(found[0], (1.0 / 2 + 2.0 / 10) / (1.0 / 2 + 1.0 / 10), 1e-12);
}

TEST(BrickStiffness, EightSamplesCount) {
  std::vector<Vector3d> places(7, {1.5, 1.5, 1.5});
  places.insert(places.end(), {{1.5, 1.5, 2.5}, {1.5, 1.5, 3.0}});
  const std::vector<double> found = brick_stiffness({{{0, 0, 0}, {}}}, {1, 1, 1, 1, 1, 1, 1, 2, 90}, Nearest(places));
  EXPECT_NEAR(found[0], (7 + 2.0 / 2) / (7 + 1.0 / 2), 1e-12);
}

}  // namespace
}  // namespace isotouch::field
