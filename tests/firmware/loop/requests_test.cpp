#include "firmware/loop/requests.h"

#include <gtest/gtest.h>

namespace isotouch::loop {
namespace {

TEST(Requests, AreTakenOnce) {
  Requests requests;
  requests.ask(kRequestStop);
  requests.ask(kRequestRestart);
  EXPECT_EQ(requests.take().bits, kRequestStop | kRequestRestart);
  EXPECT_EQ(requests.take().bits, 0);
}

TEST(Requests, ANewBeginningIsNoResume) {
  Requests requests;
  requests.ask(kRequestStop);
  requests.ask(kRequestRestart);
  EXPECT_TRUE(requests.is_stopped());
}

TEST(Requests, WhoAskedGoesWithWhatWasAsked) {
  Requests requests;
  requests.ask(kRequestStop, author_of(1000));
  requests.ask(kRequestRestart);
  EXPECT_EQ(requests.take(), (Asked{kRequestStop | kRequestRestart, author_of(1000)})) << "the controller itself is no author";
  requests.ask(kRequestStop, author_of(1000));
  requests.ask(kRequestResume, author_of(0));
  EXPECT_EQ(requests.take().author, author_of(0)) << "root came last";
  EXPECT_EQ(requests.take(), Asked{});
  requests.set({TickSetting::kWeight, -1}, author_of(7));
  requests.set({TickSetting::kFriction, 2}, author_of(8));
  EXPECT_EQ(requests.take_change(), (AskedChange{{TickSetting::kFriction, 2}, author_of(8)}));
  EXPECT_EQ(requests.take_change(), (AskedChange{{TickSetting::kWeight, -1}, author_of(7)}));
  requests.repeat_changes();
  EXPECT_EQ(requests.take_change().author, author_of(8)) << "it is still theirs when it is said again";
  EXPECT_EQ(requests.newest(TickSetting::kWeight, 0), -1);
}

TEST(Requests, OneSettingChangesInATickAndTheLaterOfTwoValuesHolds) {
  Requests requests;
  requests.set({TickSetting::kWeight, 1});
  requests.set({TickSetting::kFriction, 2});
  requests.set({TickSetting::kWeight, 3});
  EXPECT_EQ(requests.take_change().change, (SettingChange{TickSetting::kFriction, 2}));
  EXPECT_EQ(requests.take_change().change, (SettingChange{TickSetting::kWeight, 3}));
  EXPECT_EQ(requests.take_change().change, SettingChange{});
}

TEST(Requests, WhatWasEverSetIsSetAgainWhenATickForgot) {
  Requests requests;
  requests.repeat_changes();
  EXPECT_EQ(requests.take_change().change, SettingChange{});
  requests.set({TickSetting::kStiffness, 700});
  requests.take_change();
  requests.repeat_changes();
  EXPECT_EQ(requests.take_change().change, (SettingChange{TickSetting::kStiffness, 700}));
  EXPECT_EQ(requests.take_change().change, SettingChange{});
}

TEST(Requests, AnybodySeesStopsAndTheNewestSettings) {
  Requests requests;
  EXPECT_EQ(requests.newest(TickSetting::kWeight, 7), 7) << "nothing was ever asked for";
  requests.set({TickSetting::kWeight, 5});
  requests.take_change();
  EXPECT_EQ(requests.newest(TickSetting::kWeight, 7), 5) << "taken over or not";
  EXPECT_FALSE(requests.is_stopped());
  requests.ask(kRequestStop);
  requests.take();
  EXPECT_TRUE(requests.is_stopped());
  EXPECT_EQ(requests.stops(), 1U);
  requests.ask(kRequestResume);
  EXPECT_FALSE(requests.is_stopped());
  requests.ask(kRequestStop | kRequestResume);
  EXPECT_TRUE(requests.is_stopped()) << "the stop goes before the resume";
  EXPECT_EQ(requests.stops(), 2U);
}

TEST(Requests, WhatNoSettingCanBeIsNoChange) {
  Requests requests;
  requests.set({TickSetting::kStiffness, 0});  // "unset"
  requests.set({TickSetting::kFriction, -1});
  requests.set({TickSetting::kNone, 0});
  requests.set({TickSetting::kDelayTicks, 1});
  EXPECT_EQ(requests.take_change(), AskedChange{});
  requests.repeat_changes();
  EXPECT_EQ(requests.take_change(), AskedChange{});
  EXPECT_EQ(requests.newest(TickSetting::kStiffness, 7), 7);
}

TEST(Requests, AFlippedBitAsksForNothingButAStop) {
  for (std::size_t bit = 0; bit < 8 * sizeof(Requests); ++bit) {
    Requests requests;
    requests.set({TickSetting::kWeight, 5});
    static_cast<void>(requests.take_change());
    reinterpret_cast<std::uint8_t*>(&requests)[bit / 8] ^= static_cast<std::uint8_t>(1U << bit % 8);
    EXPECT_EQ(requests.take().bits & ~kRequestStop, 0) << bit;
    const SettingChange change = requests.take_change().change;
    EXPECT_TRUE(change == SettingChange{} || change == (SettingChange{TickSetting::kWeight, 5})) << bit;
    const std::int32_t newest = requests.newest(TickSetting::kWeight, 7);
    EXPECT_TRUE(newest == 5 || newest == 7) << bit;
  }
}

}  // namespace
}  // namespace isotouch::loop
