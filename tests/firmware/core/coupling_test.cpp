#include "firmware/core/coupling.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/support/accuracy.h"
#include "tests/support/reference.h"

namespace isotouch::core {
namespace {

using test::Point;
using test::Random;

constexpr PerSecond kRate = PerSecond::of(1000);

/// Only the numbers that a coupling reads.
FieldView view_with(double edge_mm, double stiffness) {
  FieldView view;
  view.edge = MmPerVoxel::from_raw(static_cast<std::int32_t>(std::lround(edge_mm * 1048576)));
  view.stiffness = Stiffness::from_raw(static_cast<std::int32_t>(std::lround(stiffness * 65536)));
  return view;
}

Contact contact_with(const Point& deflection) {
  Contact contact;
  contact.touching = true;
  contact.deflection = test::to_voxel(deflection);
  return contact;
}

Point newton(const Force& force) {
  return {force.newton.x.raw() / 65536.0, force.newton.y.raw() / 65536.0, force.newton.z.raw() / 65536.0};
}

TEST(Coupling, IsASpringOfTheFieldsStiffness) {
  const Coupling coupling = for_field(make_coupling({}, kRate), view_with(0.34, 0.8));
  Random random(41);
  double worst = 0;
  for (int i = 0; i < 5000; ++i) {
    CouplingState state;
    state.ramp = coupling.ramp_ticks;
    const Point deflection = random.in_ball(25.0);
    const Force force = couple(contact_with(deflection), {}, coupling.stiffness, coupling, state);
    EXPECT_FALSE(force.limited || force.ramping);
    worst = std::max(worst, test::length(newton(force) - test::to_point(test::to_voxel(deflection)) * (0.34 * 0.8)));
  }
  EXPECT_THAT(worst, test::IsAccuracyOf(0.00005));  // of up to 6.8 N: three roundings and the stiffness's own 16 bits
}

TEST(Coupling, TheSettingsStiffnessComesBeforeTheFields) {
  TickSettings settings;
  settings.stiffness = Stiffness::of(2.0);
  const Coupling coupling = for_field(make_coupling(settings, kRate), view_with(0.5, 0.8));
  CouplingState state;
  state.ramp = coupling.ramp_ticks;
  EXPECT_NEAR(newton(couple(contact_with({0, 0, 3}), {}, coupling.stiffness, coupling, state)).z, 3.0, 0.0001);
}

TEST(Coupling, WithoutContactThereIsNoForceInTheSameTick) {
  const Coupling coupling = for_field(make_coupling({}, kRate), view_with(0.34, 0.8));
  CouplingState state;
  couple(contact_with({5, 0, 0}), {}, coupling.stiffness, coupling, state);
  const Force left = couple(Contact{}, {}, coupling.stiffness, coupling, state);
  EXPECT_EQ(left.newton, Vec3<Newton>{});
  EXPECT_FALSE(left.limited || left.ramping);
}

TEST(Coupling, AProxyThatWasHeldInsideOrFollowedBeginsWithARamp) {
  const Coupling coupling = for_field(make_coupling({}, kRate), view_with(0.34, 0.8));
  for (const bool held : {true, false}) {
    CouplingState state;
    for (int t = 0; t < 200; ++t) {  // longer than the ramp
      Contact away;
      (held ? away.held_inside : away.following) = true;
      couple(away, {}, coupling.stiffness, coupling, state);
    }
    const Force first = couple(contact_with({0, 0, 3}), {}, coupling.stiffness, coupling, state);
    EXPECT_TRUE(first.ramping) << held;
    EXPECT_LT(newton(first).z, 0.1) << held;
  }
}

TEST(Coupling, AboveTheLimitTheForceIsShortenedAndKeepsItsDirection) {
  TickSettings settings;
  settings.force_limit = Newton::of(2.5);
  const Coupling coupling = for_field(make_coupling(settings, kRate), view_with(0.34, 0.8));
  Random random(42);
  int limited = 0;
  for (int i = 0; i < 5000; ++i) {
    CouplingState state;
    state.ramp = coupling.ramp_ticks;
    const Point deflection = random.in_ball(i % 2 == 0 ? 4000.0 : 20.0);
    const Force force = couple(contact_with(deflection), {}, coupling.stiffness, coupling, state);
    const double spring = test::length(deflection) * 0.34 * 0.8;
    if (spring < 2.49) {
      EXPECT_FALSE(force.limited);
    } else if (spring > 2.51) {
      ++limited;
      EXPECT_TRUE(force.limited);
      EXPECT_NEAR(test::length(newton(force)), 2.5, 0.0001);
      EXPECT_LT(test::angle_degrees(newton(force), deflection), 0.01);
    }
  }
  EXPECT_GT(limited, 2500);
}

TEST(Coupling, DampingFollowsTheChangeOfStretch) {
  TickSettings settings;
  settings.damping = Damping::of(0.002);  // N·s/mm
  const Coupling coupling = for_field(make_coupling(settings, kRate), view_with(0.5, 0.8));
  CouplingState state;
  state.ramp = coupling.ramp_ticks;
  couple(contact_with({0, 0, 2}), {}, coupling.stiffness, coupling, state);
  const Force force = couple(contact_with({0, 0, 2.2}), {}, coupling.stiffness, coupling, state);
  EXPECT_NEAR(newton(force).z, 2.2 * 0.5 * 0.8 + 0.002 * (0.2 * 0.5) / 0.001, 0.0005);  // spring, and 100 mm/s times b
}

TEST(Coupling, WhileTheForceLagsTheSpringIsAsLongAsItIsFelt) {
  const Coupling coupling = for_field(make_coupling({}, kRate), view_with(0.5, 0.8));
  CouplingState state;
  state.ramp = coupling.ramp_ticks;
  couple(contact_with({0, 0, 2}), {}, coupling.stiffness, coupling, state);
  begin_lag(coupling.stiffness, coupling, state);
  for (int t = 1; t <= 20; ++t) {  // the surface has risen by 4 voxels
    const Force force = couple_lagging(contact_with({0, 0, 6}), {}, false, coupling.stiffness, coupling, state);
    const double felt = 2 * 0.5 * 0.8 + 0.0475 * std::min(t, 33);
    EXPECT_NEAR(force.spring.z.raw() / 65536.0, felt, 0.001);
    EXPECT_NEAR(force.deflection.z.raw() / 1048576.0, felt / 0.8, 0.001)
        << "the energy ledger takes what the surface did for the hand's work";
  }
}

TEST(Coupling, ContactThatDidNotBeginAtRestGrowsOverTheRamp) {
  TickSettings settings;
  settings.ramp_ticks = 10;
  const Coupling coupling = for_field(make_coupling(settings, kRate), view_with(0.5, 0.8));
  CouplingState state;
  Contact away;
  away.following = true;
  couple(away, {}, coupling.stiffness, coupling, state);
  double last = 0;
  for (int t = 1; t <= 10; ++t) {
    const Force force = couple(contact_with({4, 0, 0}), {}, coupling.stiffness, coupling, state);
    EXPECT_TRUE(force.ramping);
    EXPECT_NEAR(newton(force).x, 1.6 * t / 10, 0.0005);
    EXPECT_LE(newton(force).x - last, 0.161);  // no jump
    last = newton(force).x;
  }
  EXPECT_FALSE(couple(contact_with({4, 0, 0}), {}, coupling.stiffness, coupling, state).ramping);
}

TEST(Coupling, ContactThatBeginsAtRestHasItsFullForceAtOnce) {
  const Coupling coupling = for_field(make_coupling({}, kRate), view_with(0.5, 0.8));
  CouplingState state;
  couple(Contact{}, {}, coupling.stiffness, coupling, state);  // at the HIP, in free space
  const Force force = couple(contact_with({0.5, 0, 0}), {}, coupling.stiffness, coupling, state);
  EXPECT_FALSE(force.ramping);
  EXPECT_NEAR(newton(force).x, 0.2, 0.0001);
}

}  // namespace
}  // namespace isotouch::core
