#include "firmware/core/friction.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/support/accuracy.h"
#include "tests/support/reference.h"

namespace isotouch::core {
namespace {

using test::Point;
using test::Random;

constexpr double kStiffness = 0.8;  // N/mm
const Stiffness kSurface = Stiffness::of(kStiffness);

Ratio ratio(double value) { return Ratio::from_raw(static_cast<std::int32_t>(std::lround(value * 1073741824))); }
DampingPerTick per_tick(double value) { return DampingPerTick::from_raw(static_cast<std::int32_t>(std::lround(value * 16777216))); }

Contact contact_at(const Point& proxy, const Point& deflection) {
  Contact contact;
  contact.touching = true;
  contact.proxy = test::to_voxel(proxy);
  contact.deflection = test::to_voxel(deflection);
  return contact;
}

/// The definition in doubles.
struct Twin {
  double coefficient, viscous;
  Point grip{};
  bool holds = false;
  Point offset(const Point& proxy, const Point& deflection) {
    if (!holds) {
      holds = true;
      grip = proxy;
      return {};
    }
    const Point n = test::unit(deflection);
    const Point across = grip - proxy - n * test::dot(grip - proxy, n);
    const double e = test::length(across), rim = coefficient * test::length(deflection);
    if (e <= rim) return across;
    const double left = (kStiffness * rim + viscous * e) / (kStiffness + viscous);
    grip = proxy + across * (left / e);
    return grip - proxy;
  }
};

TEST(Friction, IsThatOfTheTwin) {
  Random random(61);
  double worst = 0;
  int slid = 0;
  for (int walk = 0; walk < 300; ++walk) {
    const Friction friction = {ratio(random.uniform(0, 1.2)), per_tick(walk % 3 == 0 ? 0 : random.uniform(0, 5))};
    Twin twin = {friction.coefficient.raw() / 1073741824.0, friction.viscous.raw() / 16777216.0};
    FrictionState state;
    Point proxy = random.in_box(150), deflection = random.direction() * random.uniform(0.5, 20);
    for (int t = 0; t < 60; ++t) {
      const Contact contact = contact_at(proxy, deflection);
      const Point before = twin.grip;
      const Point exact = twin.offset(test::to_point(contact.proxy), test::to_point(contact.deflection));
      const Point felt = test::to_point(friction_offset(contact, kSurface, friction, state));
      worst = std::max(worst, test::length(felt - exact));
      slid += test::length(twin.grip - before) > 0 ? 1 : 0;
      proxy = proxy + random.in_ball(0.5);
      deflection = deflection + random.in_ball(0.1);
    }
  }
  EXPECT_GT(slid, 2000);
  EXPECT_THAT(worst, test::IsAccuracyOf(0.00015));  // voxel; errors of a slide are carried on by the next
}

TEST(Friction, WithoutContactNothingIsGripped) {
  const Friction friction = {Ratio::of(0.5), {}};
  FrictionState state;
  EXPECT_EQ(friction_offset(contact_at({1, 2, 3}, {0, 0, 2}), kSurface, friction, state), Vec3<Voxel>{});
  EXPECT_FALSE(friction_offset(contact_at({1.3, 2, 3}, {0, 0, 2}), kSurface, friction, state) == Vec3<Voxel>{});
  Contact apart = contact_at({9, 2, 3}, {});
  apart.touching = false;
  EXPECT_EQ(friction_offset(apart, kSurface, friction, state), Vec3<Voxel>{});
  EXPECT_EQ(friction_offset(contact_at({20, 2, 3}, {0, 0, 2}), kSurface, friction, state), Vec3<Voxel>{});
}

TEST(Friction, TheGripDoesNotMoveWhileItSticks) {
  const Friction friction = {Ratio::of(0.4), DampingPerTick::of(1)};
  FrictionState state;
  Random random(62);
  friction_offset(contact_at({10, 10, 10}, {0, 0, 4}), kSurface, friction, state);
  const Vec3<Voxel> grip = state.grip;
  for (int t = 0; t < 60'000; ++t) {  // a minute of tremor on a surface that bends
    const Point off = random.in_ball(0.7);
    friction_offset(contact_at(Point{10, 10, 10} + off, Point{0.05 * off.x, 0.05 * off.y, 4 + 0.2 * off.z}), kSurface, friction, state);
    ASSERT_EQ(state.grip, grip);
  }
}

TEST(Friction, ASlidingProxyFeelsCoulombsAndTheViscousForce) {
  constexpr double kSpeed = 0.02;  // voxel a tick
  for (const double viscous : {0.0, 0.5, 5.0, 50.0}) {
    const Friction friction = {Ratio::of(0.3), per_tick(viscous)};
    FrictionState state;
    Point felt{};
    for (int t = 0; t < 5000; ++t)
      felt = test::to_point(friction_offset(contact_at({kSpeed * t, 0, 0}, {0, 0, 2}), kSurface, friction, state));
    EXPECT_NEAR(-felt.x * kStiffness, kStiffness * 0.3 * 2 + viscous * kSpeed, 0.0015 + 0.002 * viscous * kSpeed) << viscous;
    EXPECT_NEAR(felt.y, 0, 0.0001);
    EXPECT_NEAR(felt.z, 0, 0.0001);
  }
}

TEST(Friction, NoDepthHoldsNothing) {
  const Friction friction = {Ratio::of(0.8), {}};
  FrictionState state;
  friction_offset(contact_at({1, 1, 1}, {0, 0, 1}), kSurface, friction, state);
  EXPECT_EQ(friction_offset(contact_at({1.5, 1, 1}, {}), kSurface, friction, state), Vec3<Voxel>{});
}

}  // namespace
}  // namespace isotouch::core
