#include "host/field/toroidal_patch.h"

#include <gtest/gtest.h>

#include <cmath>

#include "host/cloud/random.h"

namespace isotouch::field {
namespace {

using Eigen::Vector3d;

ToroidalPatch patch_at_origin(double gentle, double tight) { return {{0, 0, 0}, {0, 0, 1}, {1, 0, 0}, {0, 1, 0}, gentle, tight}; }

Vector3d random_point(cloud::Random& random, double reach) {
  return {random.uniform(-reach, reach), random.uniform(-reach, reach), random.uniform(-reach, reach)};
}

TEST(ToroidalPatch, WithoutCurvatureIsAPlane) {
  const auto patch = patch_at_origin(0, 0);
  EXPECT_DOUBLE_EQ(patch.distance({3, -4, 0.5}), 0.5);
  EXPECT_DOUBLE_EQ(patch.distance({3, -4, -7}), -7.0);
}

TEST(ToroidalPatch, WithEqualCurvaturesIsASphere) {
  const auto ball = patch_at_origin(0.1, 0.1), bowl = patch_at_origin(-0.1, -0.1);
  cloud::Random random(1);
  for (int trial = 0; trial < 200; ++trial) {
    const Vector3d x = random_point(random, 4);
    EXPECT_NEAR(ball.distance(x), (x - Vector3d(0, 0, -10)).norm() - 10, 1e-12);
    EXPECT_NEAR(bowl.distance(x), 10 - (x - Vector3d(0, 0, 10)).norm(), 1e-12);
  }
}

TEST(ToroidalPatch, IsTheDistanceToATorus) {
  // Ring of radius 70 round y, tube of radius 25, seen from the outermost point.
  const auto patch = patch_at_origin(1.0 / 95, 1.0 / 25);
  cloud::Random random(2);
  for (int trial = 0; trial < 200; ++trial) {
    const Vector3d x = random_point(random, 12);
    const Vector3d c = x - Vector3d(0, 0, -95);
    const double ring = std::hypot(std::hypot(c.x(), c.z()) - 70, c.y()) - 25;
    EXPECT_NEAR(patch.distance(x), ring, 1e-11);
  }
}

TEST(ToroidalPatch, NeverShowsItsFarSide) {
  const auto patch = patch_at_origin(0.5, 0.5);  // a ball of radius 2
  for (double depth = 0.1; depth < 50; depth *= 1.3) EXPECT_LT(patch.distance({0, 0, -depth}), 0) << depth;
  const auto bowl = patch_at_origin(-0.5, -0.5);
  for (double height = 0.1; height < 50; height *= 1.3) EXPECT_GT(bowl.distance({0, 0, height}), 0) << height;
}

TEST(ToroidalPatch, GradientIsTheSlopeAndAtMostOne) {
  cloud::Random random(4);
  for (const auto& [gentle, tight] : {std::pair(0.0, 0.1), {0.02, 0.3}, {-0.05, 0.2}, {0.05, -0.2}, {-0.1, -0.4}}) {
    const auto patch = patch_at_origin(gentle, tight);
    for (int trial = 0; trial < 200; ++trial) {
      const Vector3d x = random_point(random, 8);
      const auto here = patch.value(x);
      EXPECT_NEAR(here.distance, patch.distance(x), 1e-12);
      EXPECT_LE(here.gradient.norm(), 1 + 1e-12);
      const Vector3d step = random_point(random, 1e-5);
      EXPECT_NEAR(patch.distance(x + step) - patch.distance(x - step), 2 * here.gradient.dot(step), 1e-8);
    }
  }
}

}  // namespace
}  // namespace isotouch::field
