#include "host/view/markers.h"

#include <gtest/gtest.h>

#include <cmath>

#include "host/view/palette.h"

namespace isotouch::view {
namespace {

constexpr double kRadius = 1, kArrow = 8;

/// HIP at -5, proxy at 0, force along +x; rays come down along -z.
Markers markers() { return Markers({.proxy = {0, 0, 0}, .hip = {-5, 0, 0}, .force = {2, 0, 0}}, kRadius, kArrow); }

Ray down(double x, double y) { return {{x, y, 20}, {0, 0, -1}}; }

bool same(const Colour& a, const Colour& b) { return a.r == b.r && a.g == b.g && a.b == b.b; }

/// Half the width across, where a ray through (x, y) still meets the markers.
double half_width(double x) {
  double y = 0;
  while (markers().hit(down(x, y)) && y < 5) y += 0.001;
  return y;
}

TEST(Markers, AreABallACubeABarAndAnArrow) {
  EXPECT_NEAR(half_width(0), kRadius, 0.002);
  EXPECT_NEAR(half_width(0.6), 0.8 * kRadius, 0.002) << "a ball is round";
  EXPECT_NEAR(half_width(-5), 0.85 * kRadius, 0.002);
  EXPECT_NEAR(half_width(-5.8), 0.85 * kRadius, 0.002) << "a cube is not";
  EXPECT_NEAR(half_width(-2.5), 0.3 * kRadius, 0.002);
  EXPECT_NEAR(half_width(3), 0.3 * kRadius, 0.002);
  EXPECT_NEAR(half_width(kArrow - 2.2), 0.9 * kRadius, 0.002) << "the head is widest at its foot";
  EXPECT_NEAR(half_width(kArrow - 1.1), 0.45 * kRadius, 0.002);
  EXPECT_EQ(half_width(kArrow + 0.01), 0);
}

TEST(Markers, HaveTheirOwnColours) {
  EXPECT_TRUE(same(markers().hit(down(0, 0))->colour, kProxyColour));
  EXPECT_TRUE(same(markers().hit(down(-5, 0))->colour, kHipColour));
  EXPECT_TRUE(same(markers().hit(down(3, 0))->colour, kForceColour));
}

TEST(Markers, AreHitFromOutsideWithANormalTowardsTheEye) {
  for (const double x : {-5.5, -5.0, -2.5, 0.0, 0.5, 3.0, 6.5}) {
    for (const double height : {20.0, -20.0}) {
      const Ray ray{{x, 0.05, height}, {0, 0, height > 0 ? -1.0 : 1.0}};
      const auto hit = markers().hit(ray);
      ASSERT_TRUE(hit) << x;
      EXPECT_LT(hit->normal.dot(ray.direction), -0.5) << x;
      EXPECT_NEAR(hit->normal.norm(), 1, 1e-9);
      EXPECT_GT(ray.at(hit->t).z() * height, 0) << "the nearer side";
    }
  }
}

TEST(Markers, WithoutAForceHaveNoArrow) {
  const Markers still({.proxy = {0, 0, 0}, .hip = {-5, 0, 0}}, kRadius, kArrow);
  EXPECT_FALSE(still.hit(down(3, 0)));
  EXPECT_TRUE(still.hit(down(-2.5, 0)));
}

}  // namespace
}  // namespace isotouch::view
