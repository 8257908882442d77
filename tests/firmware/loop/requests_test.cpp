#include "firmware/loop/requests.h"

#include <gtest/gtest.h>

namespace isotouch::loop {
namespace {

TEST(Requests, AreTakenOnce) {
  Requests requests;
  requests.ask(kRequestStop);
  requests.ask(kRequestRestart);
  EXPECT_EQ(requests.take(), kRequestStop | kRequestRestart);
  EXPECT_EQ(requests.take(), 0);
}

TEST(Requests, OneSettingChangesInATickAndTheLaterOfTwoValuesHolds) {
  Requests requests;
  requests.set({TickSetting::kWeight, 1});
  requests.set({TickSetting::kFriction, 2});
  requests.set({TickSetting::kWeight, 3});
  EXPECT_EQ(requests.take_change(), (SettingChange{TickSetting::kFriction, 2}));
  EXPECT_EQ(requests.take_change(), (SettingChange{TickSetting::kWeight, 3}));
  EXPECT_EQ(requests.take_change(), SettingChange{});
}

TEST(Requests, WhatWasEverSetIsSetAgainWhenATickForgot) {
  Requests requests;
  requests.repeat_changes();
  EXPECT_EQ(requests.take_change(), SettingChange{});
  requests.set({TickSetting::kStiffness, 7});
  requests.take_change();
  requests.repeat_changes();
  EXPECT_EQ(requests.take_change(), (SettingChange{TickSetting::kStiffness, 7}));
  EXPECT_EQ(requests.take_change(), SettingChange{});
}

}  // namespace
}  // namespace isotouch::loop
