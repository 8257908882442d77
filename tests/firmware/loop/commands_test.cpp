#include "firmware/loop/commands.h"

#include <gtest/gtest.h>

namespace isotouch::loop {
namespace {

TEST(Commands, AreTakenOnce) {
  Commands commands;
  commands.ask(kCommandStop);
  commands.ask(kCommandRestart);
  EXPECT_EQ(commands.take(), kCommandStop | kCommandRestart);
  EXPECT_EQ(commands.take(), 0);
}

TEST(Commands, OneSettingChangesInATickAndTheLaterOfTwoValuesHolds) {
  Commands commands;
  commands.set({TickSetting::kWeight, 1});
  commands.set({TickSetting::kFriction, 2});
  commands.set({TickSetting::kWeight, 3});
  EXPECT_EQ(commands.take_change(), (SettingChange{TickSetting::kFriction, 2}));
  EXPECT_EQ(commands.take_change(), (SettingChange{TickSetting::kWeight, 3}));
  EXPECT_EQ(commands.take_change(), SettingChange{});
}

TEST(Commands, WhatWasEverSetIsSetAgainWhenATickForgot) {
  Commands commands;
  commands.repeat_changes();
  EXPECT_EQ(commands.take_change(), SettingChange{});
  commands.set({TickSetting::kStiffness, 7});
  commands.take_change();
  commands.repeat_changes();
  EXPECT_EQ(commands.take_change(), (SettingChange{TickSetting::kStiffness, 7}));
  EXPECT_EQ(commands.take_change(), SettingChange{});
}

}  // namespace
}  // namespace isotouch::loop
