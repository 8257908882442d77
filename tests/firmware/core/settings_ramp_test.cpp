#include "firmware/core/settings_ramp.h"

#include <gtest/gtest.h>

#include <cstdlib>

namespace isotouch::core {
namespace {

constexpr SettingChange kNothing;

Coupling coupling_with(std::uint32_t ramp_ticks) {
  TickSettings settings;
  settings.ramp_ticks = ramp_ticks;
  Coupling coupling = make_coupling(settings, PerSecond::of(1000));
  coupling.stiffness = Stiffness::of(0.8);
  return coupling;
}

TEST(SettingsRamp, AValueMovesStraightToItsTargetAndArrives) {
  const Coupling coupling = coupling_with(40);
  SettingsRamp ramp;
  begin_settings({}, ramp);
  const std::int32_t target = Ratio::of(0.5).raw();
  ASSERT_TRUE(advance_settings({TickSetting::kFriction, target}, false, coupling, ramp));
  for (int t = 1; t < 40; ++t) {
    EXPECT_LT(std::abs(ramp.now[3] - target / 40 * t), 100) << t;
    ASSERT_TRUE(advance_settings(kNothing, false, coupling, ramp));
  }
  EXPECT_EQ(ramp.now[3], target);
  EXPECT_FALSE(advance_settings(kNothing, false, coupling, ramp));
}

TEST(SettingsRamp, AChangeUnderWayGoesOnFromWhereItIs) {
  const Coupling coupling = coupling_with(40);
  SettingsRamp ramp;
  begin_settings({}, ramp);
  advance_settings({TickSetting::kFriction, 400'000}, false, coupling, ramp);
  for (int t = 0; t < 19; ++t) advance_settings(kNothing, false, coupling, ramp);
  EXPECT_NEAR(ramp.now[3], 200'000, 20);
  advance_settings({TickSetting::kHandDamping, 8'000}, false, coupling, ramp);
  EXPECT_NEAR(ramp.now[3], 205'000, 20);
  EXPECT_NEAR(ramp.now[5], 200, 1);
  for (int t = 0; t < 39; ++t) advance_settings(kNothing, false, coupling, ramp);
  EXPECT_EQ(ramp.now[3], 400'000);
  EXPECT_EQ(ramp.now[5], 8'000);
}

TEST(SettingsRamp, WhereNothingIsFeltTheTargetHoldsAtOnce) {
  SettingsRamp ramp;
  begin_settings({}, ramp);
  EXPECT_TRUE(advance_settings({TickSetting::kWeight, 77}, true, coupling_with(40), ramp));
  EXPECT_EQ(ramp.now[7], 77);
  EXPECT_FALSE(advance_settings(kNothing, true, coupling_with(40), ramp));
  EXPECT_TRUE(advance_settings({TickSetting::kWeight, -5}, false, coupling_with(0), ramp));
  EXPECT_EQ(ramp.now[7], -5);
}

TEST(SettingsRamp, AStiffnessThatWasTheFieldsSetsOutFromThat) {
  SettingsRamp ramp;
  begin_settings({}, ramp);
  EXPECT_EQ(ramp.now[0], 0);
  advance_settings({TickSetting::kStiffness, Stiffness::of(1.6).raw()}, false, coupling_with(8), ramp);
  EXPECT_NEAR(ramp.now[0] / 65536.0, 0.9, 0.0001);
}

TEST(SettingsRamp, AnInvalidChangeIsNone) {
  SettingsRamp ramp;
  begin_settings({}, ramp);
  const SettingsRamp before = ramp;
  EXPECT_FALSE(advance_settings({TickSetting::kStiffness, -1}, false, coupling_with(8), ramp));
  EXPECT_FALSE(advance_settings({static_cast<TickSetting>(31), 1}, false, coupling_with(8), ramp));
  EXPECT_EQ(ramp.now, before.now);
  EXPECT_EQ(ramp.target, before.target);
}

}  // namespace
}  // namespace isotouch::core
