#include "firmware/settings/live.h"

#include <gtest/gtest.h>

#include <string>

namespace isotouch::settings {
namespace {

TEST(LiveSettings, WhatIsSetReachesTheTickInItsFormat) {
  loop::Commands commands;
  LiveSettings live{Settings{}};
  EXPECT_EQ(live.set("friction", "0.5", commands), "");
  EXPECT_EQ(commands.take_change(), (SettingChange{TickSetting::kFriction, Ratio::of(0.5).raw()}));
  EXPECT_EQ(commands.take_change(), SettingChange{});
  EXPECT_EQ(live.set("feel.stiffness", "1.25", commands), "");
  EXPECT_EQ(commands.take_change(), (SettingChange{TickSetting::kStiffness, Stiffness::of(1.25).raw()}));
  EXPECT_EQ(live.set("weight_n", "-0.75", commands), "");
  EXPECT_EQ(commands.take_change(), (SettingChange{TickSetting::kWeight, Newton::of(-0.75).raw()}));
  EXPECT_EQ(live.now().friction, 0.5);
  EXPECT_EQ(live.now().stiffness, 1.25);
  EXPECT_EQ(live.set("friction", "0.5", commands), "");  // as it is
  EXPECT_EQ(commands.take_change(), SettingChange{});
}

TEST(LiveSettings, WhatCannotBeIsRefusedInOneSentenceAndChangesNothing) {
  loop::Commands commands;
  LiveSettings live{Settings{}};
  EXPECT_EQ(live.set("friction", "2", commands), "feel.friction must be a number from 0 to 1.5");
  EXPECT_EQ(live.set("hand_damping", "-1", commands), "feel.hand_damping must be a number from 0 to 0.1 N s/mm");
  for (const char* value : {"", "much", "0.5x", "nan", "inf", "0.5 0.6"}) EXPECT_NE(live.set("friction", value, commands), "") << value;
  for (const char* name : {"", "tick_hz", "ramp_ms", "loop.tick_hz", "feel.", "frictio"}) {
    EXPECT_EQ(live.set(name, "1", commands).find("cannot be set while running; it may be one of stiffness, damping") != std::string::npos,
              true)
        << name;
  }
  EXPECT_EQ(live.set("stiffness", "2.5", commands), "that is too stiff for this device at this rate; feel.stiffness may be at most 2 N/mm");
  EXPECT_EQ(live.set("stiffness", "1.5", commands, 2),
            "that is too stiff for this device at this rate and its measured delay of 2 ticks; feel.stiffness may be at most 1.2 N/mm")
      << "0.003 N s/mm, 1 ms";
  EXPECT_EQ(live.set("force_limit_n", "0", commands), "feel.force_limit_n must be more than nothing");
  EXPECT_EQ(commands.take_change(), SettingChange{});
  EXPECT_EQ(live.now(), Settings{});
}

TEST(LiveSettings, ALongerDelayThanTheSettingsKnowLowersAStiffnessThatIsTooMuchForIt) {
  loop::Commands commands;
  Settings settings;
  LiveSettings without{settings};
  EXPECT_EQ(without.keep_within(commands, 3), "") << "the field's own counts";
  settings.stiffness = 1.2;  // 2 * 0.003 / (5 * 1 ms) just holds it
  LiveSettings live{settings};
  EXPECT_EQ(live.keep_within(commands, 2), "");
  EXPECT_EQ(live.now(), settings);
  EXPECT_EQ(live.keep_within(commands, 3),
            "with the measured delay of 3 ticks this device holds no more than 0.857 N/mm at this rate; feel.stiffness is so much now");
  EXPECT_EQ(live.now().stiffness, 0.857);
  EXPECT_EQ(commands.take_change(), (SettingChange{TickSetting::kStiffness, Stiffness::of(0.857).raw()}));
  EXPECT_EQ(live.keep_within(commands, 3), "");
  EXPECT_NE(live.keep_within(commands, 5), "");
  EXPECT_EQ(live.now().stiffness, 0.545);
}

}  // namespace
}  // namespace isotouch::settings
