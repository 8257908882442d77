#include "firmware/settings/live.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <utility>

#include "shared/trace.h"
#include "tests/firmware/loop/loop_bench.h"

namespace isotouch::settings {
namespace {

TEST(LiveSettings, WhatIsSetReachesTheTickInItsFormat) {
  loop::Requests commands;
  LiveSettings live{Settings{}};
  EXPECT_EQ(live.set("friction", "0.5", commands).sentence(), "");
  EXPECT_EQ(commands.take_change().change, (SettingChange{TickSetting::kFriction, Ratio::of(0.5).raw()}));
  EXPECT_EQ(commands.take_change().change, SettingChange{});
  EXPECT_EQ(live.set("feel.stiffness", "1.25", commands).sentence(), "");
  EXPECT_EQ(commands.take_change().change, (SettingChange{TickSetting::kStiffness, Stiffness::of(1.25).raw()}));
  EXPECT_EQ(live.set("weight_n", "-0.75", commands).sentence(), "");
  EXPECT_EQ(commands.take_change().change, (SettingChange{TickSetting::kWeight, Newton::of(-0.75).raw()}));
  EXPECT_EQ(live.now().friction, 0.5);
  EXPECT_EQ(live.now().stiffness, 1.25);
  EXPECT_EQ(live.set("friction", "0.5", commands).sentence(), "");  // as it is
  EXPECT_EQ(commands.take_change().change, SettingChange{});
}

TEST(LiveSettings, ARangeHoldsItsEndsAndNothingBeyond) {
  LiveSettings live({});
  loop::Requests requests;
  for (const char* end : {"0", "1.5"}) EXPECT_EQ(live.set("friction", end, requests, 0).sentence(), "") << end;
  for (const char* beyond : {"-0.0001", "1.5001"}) EXPECT_TRUE(live.set("friction", beyond, requests, 0)) << beyond;
}

TEST(LiveSettings, WhatCannotBeIsRefusedInOneSentenceAndChangesNothing) {
  loop::Requests commands;
  LiveSettings live{Settings{}};
  EXPECT_EQ(live.set("friction", "2", commands).sentence(), "feel.friction must be a number from 0 to 1.5");
  EXPECT_EQ(live.set("hand_damping", "-1", commands).sentence(), "feel.hand_damping must be a number from 0 to 0.1 N s/mm");
  for (const char* value : {"", "much", "0.5x", "nan", "inf", "0.5 0.6"})
    EXPECT_NE(live.set("friction", value, commands).sentence(), "") << value;
  for (const char* name : {"tick_hz", "ramp_ms", "loop.tick_hz"}) {
    EXPECT_EQ(live.set(name, "1", commands).sentence(),
              std::string("'") + name + "' can only be set at the start; write it into the settings file and start the controller again");
  }
  EXPECT_EQ(live.set("frictoin", "1", commands).sentence(), "there is no setting 'frictoin'; did you mean 'friction'?");
  EXPECT_EQ(live.set("feel.frictio", "1", commands).sentence(), "there is no setting 'frictio'; did you mean 'friction'?");
  for (const char* name : {"", "feel.", "colour"}) {
    EXPECT_THAT(live.set(name, "1", commands).sentence(),
                testing::HasSubstr("'; while the controller runs it may be one of stiffness, damping, "))
        << name;
  }
  EXPECT_EQ(live.set("stiffness", "2.5", commands).sentence(),
            "that is too stiff for this device at this rate; feel.stiffness may be at most 2 N/mm");
  EXPECT_EQ(live.set("stiffness", "1.5", commands, 2).sentence(),
            "that is too stiff for this device at this rate and its measured delay of 2 ticks; feel.stiffness may be at most 1.2 N/mm")
      << "0.003 N s/mm, 1 ms";
  EXPECT_EQ(live.set("force_limit_n", "50.1", commands).sentence(), "feel.force_limit_n must be a number from 0 to 50 N");
  EXPECT_EQ(commands.take_change().change, SettingChange{});
  EXPECT_EQ(live.now(), Settings{});
}

TEST(LiveSettings, WhoMayNotRaiseLimitsStaysWithinThoseOfTheStart) {
  loop::Requests requests;
  Settings settings;
  settings.force_limit_n = 5;
  settings.weight_n = -0.8;
  LiveSettings live{settings};
  const Setter operates{author_of(1000), false, Stiffness::of(0.8)}, services{author_of(1001), true, Stiffness::of(0.8)};
  const auto set = [&](const char* name, const char* value, const Setter& setter) {
    return live.set(name, value, requests, 0, setter).sentence();
  };
  const std::string limit =
      " for the role operate, by what the controller was started with, the field or the device; ask somebody with the role service";
  EXPECT_EQ(set("force_limit_n", "5.01", operates), "feel.force_limit_n may be at most 5" + limit);
  EXPECT_EQ(set("weight_n", "0.81", operates), "feel.weight_n may be at most 0.8" + limit);
  EXPECT_EQ(set("stiffness", "0.81", operates).find("feel.stiffness may be at most 0.8"), 0U) << "the field's own";
  EXPECT_EQ(requests.take_change(), loop::AskedChange{});
  for (const auto& [name, value] : {std::pair("force_limit_n", "4.5"), {"weight_n", "0.8"}, {"stiffness", "0.75"}, {"friction", "1.5"}}) {
    EXPECT_EQ(set(name, value, operates), "") << name;
    EXPECT_EQ(requests.take_change().author, author_of(1000)) << name;
  }
  EXPECT_EQ(set("force_limit_n", "6", services), "");
  EXPECT_EQ(requests.take_change().author, author_of(1001));
  EXPECT_NE(set("force_limit_n", "6", operates), "") << "what somebody raised is no new limit for others";
  EXPECT_EQ(set("stiffness", "0.1", {author_of(1000), false, Stiffness{}}),
            "feel.stiffness: the limit for the role operate is the field's own stiffness, and there is no field; load one first");
  settings.stiffness = 0.5;
  LiveSettings lower{settings};
  EXPECT_TRUE(lower.set("stiffness", "0.6", requests, 0, operates)) << "what the settings name counts more than the field's own";
  EXPECT_FALSE(lower.set("stiffness", "0.5", requests, 0, operates));
}

TEST(LiveSettings, WhoMayNotRaiseLimitsSetsNoDampingThatTrembles) {
  loop::Requests requests;
  const Setter operates{author_of(1000), false, Stiffness::of(0.8)}, services{author_of(1001), true, Stiffness::of(0.8)};
  Settings damped;
  damped.damping = damped.friction_damping = damped.hand_damping = damped.passivity_damping = 0.02;
  for (const std::string name : {"damping", "friction_damping", "hand_damping", "passivity_damping"}) {
    LiveSettings live{Settings{}}, more{damped};
    EXPECT_EQ(live.set(name, "0.012", requests, 0, operates).sentence(), "") << name;
    EXPECT_EQ(
        live.set(name, "0.0121", requests, 0, operates).sentence().find("feel." + name + " may be at most 0.012 for the role operate"), 0U)
        << name;
    EXPECT_EQ(live.set(name, "0.1", requests, 0, services).sentence(), "") << name;
    EXPECT_TRUE(live.set(name, "0.05", requests, 0, operates)) << name << ": what somebody raised is no new limit for others";
    EXPECT_EQ(more.set(name, "0.02", requests, 0, operates).sentence(), "") << name << ": as the controller was started";
    EXPECT_TRUE(more.set(name, "0.021", requests, 0, operates)) << name;
  }
}

TEST(LiveSettings, WhatOneFieldAllowedIsNotKeptForAnotherThatIsSofter) {
  loop::Requests requests;
  const Setter operates{author_of(1000), false, Stiffness::of(0.8)}, services{author_of(1001), true, Stiffness::of(0.8)};
  LiveSettings live{Settings{}};
  EXPECT_EQ(live.set("stiffness", "0.75", requests, 0, operates).sentence(), "");
  EXPECT_EQ(requests.take_change().change, (SettingChange{TickSetting::kStiffness, Stiffness::of(0.75).raw()}));
  EXPECT_EQ(live.keep_within_field(requests, Stiffness::of(0.9)), "");
  EXPECT_EQ(live.keep_within_field(requests, Stiffness::of(0.75)), "");
  EXPECT_EQ(requests.take_change(), loop::AskedChange{});
  EXPECT_EQ(live.keep_within_field(requests, Stiffness::of(0.3)),
            "feel.stiffness fell to the new field's own, the limit for the role operate");
  EXPECT_EQ(requests.take_change().change, (SettingChange{TickSetting::kStiffness, Stiffness::of(0.3).raw()})) << "the field's own";
  EXPECT_EQ(live.keep_within_field(requests, Stiffness::of(0.3)), "") << "said once";
  EXPECT_NE(live.keep_within_field(requests, Stiffness::of(0.2)), "") << "an even softer one is the limit next";
  EXPECT_EQ(requests.take_change().change, (SettingChange{TickSetting::kStiffness, Stiffness::of(0.2).raw()}));
  EXPECT_EQ(live.set("stiffness", "0.75", requests, 0, operates).sentence(), "");
  EXPECT_EQ(live.set("stiffness", "0.7", requests, 0, services).sentence(), "");
  EXPECT_EQ(live.keep_within_field(requests, Stiffness::of(0.3)), "") << "the role service may";
  Settings named;
  named.stiffness = 0.5;
  LiveSettings of_a_file{named};
  EXPECT_EQ(of_a_file.set("stiffness", "0.4", requests, 0, operates).sentence(), "");
  EXPECT_EQ(of_a_file.keep_within_field(requests, Stiffness::of(0.3)), "") << "the settings name the limit";
}

TEST(LiveSettings, WhatFallsToASofterFieldsOwnIsFeltAndItsRecordsCanBeRead) {
  loop::Bench bench;
  LiveSettings live{Settings{}};
  const Stiffness stiff = Stiffness::of(0.79), soft = Stiffness::of(0.2);
  const auto felt = [&] { return bench.loop.state().settings.target[index_of(TickSetting::kStiffness)]; };
  ASSERT_FALSE(live.set("stiffness", "0.79", bench.requests, 0, {author_of(1000), false, Stiffness::of(0.8)}));
  bench.steps(1);
  EXPECT_EQ(felt(), stiff.raw());
  EXPECT_NE(live.keep_within_field(bench.requests, soft), "");
  for (const bool again : {false, true}) {
    if (again) bench.requests.ask(kRequestRestart);
    for (int n = 0; n < 3; ++n) {
      const loop::TickRecord record = bench.step();
      EXPECT_TRUE(decode_record(encode(TraceRecord{record.in, record.out, 0, 0})));
    }
    EXPECT_EQ(felt(), soft.raw());
  }
}

TEST(LiveSettings, AStiffnessFallsNoFurtherThanItCanBeSet) {
  loop::Requests requests;
  const SettingChange least{TickSetting::kStiffness, rows::kStiffness.raw(rows::kStiffness.low)};
  LiveSettings on_a_field{Settings{}};
  EXPECT_EQ(on_a_field.set("stiffness", "0.75", requests, 0, {author_of(1000), false, Stiffness::of(0.8)}).sentence(), "");
  static_cast<void>(requests.take_change());
  EXPECT_NE(on_a_field.keep_within_field(requests, Stiffness::of(0.0001)), "");
  EXPECT_EQ(requests.take_change().change, least);
  EXPECT_EQ(on_a_field.keep_within_field(requests, Stiffness::of(0.0001)), "");
  Settings settings;
  settings.stiffness = 0.1;
  settings.damping_n_s_mm = rows::kDeviceDamping.low;
  LiveSettings with_a_delay{settings};
  EXPECT_NE(with_a_delay.keep_within(requests, 500), "") << "2 * 0.0001 / (1001 * 1 ms)";
  EXPECT_EQ(requests.take_change().change, least);
  EXPECT_EQ(with_a_delay.now().stiffness, 0.001);
  EXPECT_EQ(with_a_delay.keep_within(requests, 500), "");
}

TEST(LiveSettings, ALongerDelayThanTheSettingsKnowLowersAStiffnessThatIsTooMuchForIt) {
  loop::Requests commands;
  Settings settings;
  LiveSettings without{settings};
  EXPECT_EQ(without.keep_within(commands, 3), "") << "the field's own counts";
  settings.stiffness = 1.2;  // 2 * 0.003 / (5 * 1 ms) just holds it
  LiveSettings live{settings};
  EXPECT_EQ(live.keep_within(commands, 2), "");
  EXPECT_EQ(live.now(), settings);
  EXPECT_EQ(live.keep_within(commands, 3),
            "feel.stiffness was lowered to 0.857 N/mm, the largest that this device can render stably at this rate with the measured delay "
            "of 3 ticks");
  EXPECT_EQ(live.now().stiffness, 0.857);
  EXPECT_EQ(commands.take_change().change, (SettingChange{TickSetting::kStiffness, Stiffness::of(0.857).raw()}));
  EXPECT_EQ(live.keep_within(commands, 3), "");
  EXPECT_NE(live.keep_within(commands, 5), "");
  EXPECT_EQ(live.now().stiffness, 0.545);
}

}  // namespace
}  // namespace isotouch::settings
