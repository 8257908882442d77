#include "host/cloud/bodies.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "host/cloud/random.h"

namespace isotouch::cloud {
namespace {

using Eigen::Vector3d;

using Named = std::pair<std::string, Body>;

/// Bodies with Euclidean distance on both sides.
std::vector<Named> exact_bodies() {
  return {{"sphere", sphere({1, 2, 3}, 4)},
          {"capsule", capsule({-3, 0, 1}, {4, 2, -1}, 2)},
          {"round cone", round_cone({-4, 0, 0}, 3, {4, 1, 2}, 1)},
          {"round cone, growing", round_cone({0, 0, 0}, 1, {0, 5, 0}, 2.5)},
          {"cone stump", cone_stump({0, -3, 1}, 4, {1, 4, 0}, 1.5)},
          {"cone stump, growing", cone_stump({0, 0, 0}, 1, {0, 0, 3}, 5)},
          {"cylinder", cylinder({-2, -2, 0}, {3, 2, 1}, 2.5)},
          {"torus", torus({0, 1, 0}, {1, 1, 0}, 5, 1.5)},
          {"box", box({1, 0, 0}, {4, 3, 2})},
          {"rounded box", box({0, 0, 1}, {4, 3, 2}, 1)}};
}

std::vector<Named> all_bodies() {
  std::vector<Named> all = exact_bodies();
  all.emplace_back("ellipsoid", ellipsoid({0, 1, 0}, {5, 3, 2}, {1, 1, 0}, {0, 1, 1}));
  all.emplace_back("half space", half_space({0, 1, 0}, {1, 2, 3}));
  all.emplace_back("union", unite({sphere({-2, 0, 0}, 3), box({2, 0, 0}, {3, 2, 1}), torus({0, 0, 0}, {0, 0, 1}, 6, 1)}));
  all.emplace_back("intersection", intersect({sphere({0, 0, 0}, 5), half_space({0, 1, 0}, {0, 1, 1})}));
  all.emplace_back("difference", subtract(box({0, 0, 0}, {4, 4, 4}), sphere({4, 4, 4}, 3)));
  all.emplace_back("mirrored", mirror_x(round_cone({1, 0, 0}, 2, {6, 1, 1}, 1)));
  return all;
}

Vector3d somewhere(Random& random) {
  const double x = random.uniform(-9, 9);
  const double y = random.uniform(-9, 9);
  const double z = random.uniform(-9, 9);
  return {x, y, z};
}

TEST(Bodies, TheFootOfAEuclideanDistanceLiesOnTheSurface) {
  for (const auto& [name, body] : exact_bodies()) {
    Random random(1);
    for (int i = 0; i < 2000; ++i) {
      const Vector3d p = somewhere(random);
      const Probe probe = body(p);
      EXPECT_NEAR(body(p - probe.distance * probe.gradient).distance, 0.0, 1e-9) << name << " at " << p.transpose();
    }
  }
}

TEST(Bodies, NoStepOfTheDistanceLeavesTheSideItBeganOn) {
  for (const auto& [name, body] : all_bodies()) {
    Random random(2);
    for (int i = 0; i < 2000; ++i) {
      const Vector3d p = somewhere(random);
      const double distance = body(p).distance;
      const Vector3d q = p + 0.999 * std::abs(distance) * somewhere(random).normalized();
      EXPECT_EQ(distance < 0.0, body(q).distance < 0.0) << name << " from " << p.transpose() << " to " << q.transpose();
    }
  }
}

TEST(Bodies, GradientsAreUnitAndNearTheSurfaceThoseOfTheDistance) {
  for (const auto& [name, body] : all_bodies()) {
    Random random(3);
    int compared = 0;
    int creased = 0;
    for (int i = 0; i < 4000; ++i) {
      const Vector3d p = somewhere(random);
      const Probe probe = body(p);
      EXPECT_NEAR(probe.gradient.norm(), 1.0, 1e-12) << name;
      Vector3d slope;
      for (int axis = 0; axis < 3; ++axis) {
        const Vector3d step = 1e-6 * Vector3d::Unit(axis);
        slope[axis] = (body(p + step).distance - body(p - step).distance) / 2e-6;
      }
      if (std::abs(probe.distance) > 1.0 || slope.norm() < 0.3) continue;
      ++compared;
      if ((slope.normalized() - probe.gradient).norm() > 1e-4) ++creased;  // the probe straddles a crease or a medial plane
    }
    EXPECT_GT(compared, 100) << name;
    EXPECT_LE(creased, compared / 100) << name;
  }
}

TEST(Bodies, KnownDistances) {
  EXPECT_DOUBLE_EQ(box({0, 0, 0}, {80, 60, 2})(Vector3d(83, 64, 0)).distance, 5.0);
  EXPECT_DOUBLE_EQ(box({0, 0, 0}, {80, 60, 2})(Vector3d(0, 0, 1)).distance, -1.0);
  EXPECT_DOUBLE_EQ(torus({0, 0, 0}, {0, 0, 1}, 70, 25)(Vector3d(0, 0, 0)).distance, 45.0);
  EXPECT_DOUBLE_EQ(cylinder({0, 0, 0}, {0, 10, 0}, 4)(Vector3d(7, 14, 0)).distance, 5.0);
  EXPECT_DOUBLE_EQ(cone_stump({0, 0, 0}, 3, {0, 4, 0}, 0)(Vector3d(4, 3, 0)).distance, 2.6);  // mantle 4 x + 3 y = 12
}

TEST(Bodies, PointsOnAnAxisGetAGradientToo) {
  EXPECT_DOUBLE_EQ(torus({0, 0, 0}, {1, 0, 0}, 5, 1)(Vector3d(0, 0, 0)).distance, 4.0);
  EXPECT_DOUBLE_EQ(capsule({-2, 0, 0}, {2, 0, 0}, 1)(Vector3d(0, 0, 0)).distance, -1.0);
  for (const auto& [name, body] : all_bodies()) EXPECT_NEAR(body(Vector3d(0, 0, 0)).gradient.norm(), 1.0, 1e-12) << name;
}

}  // namespace
}  // namespace isotouch::cloud
