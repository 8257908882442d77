#include "shared/setting_change.h"

#include <gtest/gtest.h>

#include <cstdint>

namespace isotouch {
namespace {

TEST(SettingChange, RawValuesGoInAndComeOutInTheOrderOfTheirNumbers) {
  const RawSettings raw = {1, 2, 3, 4, 5, 6, 7, 8};
  TickSettings settings;
  store(raw, settings);
  EXPECT_EQ(raw_settings(settings), raw);
  EXPECT_EQ(settings.stiffness.raw(), static_cast<int>(TickSetting::kStiffness));
  EXPECT_EQ(settings.damping.raw(), static_cast<int>(TickSetting::kDamping));
  EXPECT_EQ(settings.force_limit.raw(), static_cast<int>(TickSetting::kForceLimit));
  EXPECT_EQ(settings.friction.raw(), static_cast<int>(TickSetting::kFriction));
  EXPECT_EQ(settings.friction_damping.raw(), static_cast<int>(TickSetting::kFrictionDamping));
  EXPECT_EQ(settings.hand_damping.raw(), static_cast<int>(TickSetting::kHandDamping));
  EXPECT_EQ(settings.passivity.raw(), static_cast<int>(TickSetting::kPassivity));
  EXPECT_EQ(settings.weight.raw(), static_cast<int>(TickSetting::kWeight));
}

TEST(SettingChange, OnlyValuesWithinTheirRangeAreValid) {
  const auto valid = [](TickSetting setting, std::int64_t raw) { return is_valid({setting, static_cast<std::int32_t>(raw)}); };
  EXPECT_TRUE(valid(TickSetting::kNone, 0));
  EXPECT_FALSE(valid(TickSetting::kNone, 1));
  EXPECT_FALSE(valid(TickSetting::kStiffness, 0));
  EXPECT_TRUE(valid(TickSetting::kStiffness, 1));
  EXPECT_FALSE(valid(TickSetting::kForceLimit, 0));
  EXPECT_TRUE(valid(TickSetting::kFriction, kMostFriction.raw()));
  EXPECT_FALSE(valid(TickSetting::kFriction, kMostFriction.raw() + 1));
  EXPECT_FALSE(valid(TickSetting::kHandDamping, -1));
  EXPECT_TRUE(valid(TickSetting::kWeight, (-kMostWeight).raw()));
  EXPECT_FALSE(valid(TickSetting::kWeight, (-kMostWeight).raw() - 1));
  EXPECT_FALSE(valid(static_cast<TickSetting>(9), 5));
}

}  // namespace
}  // namespace isotouch
