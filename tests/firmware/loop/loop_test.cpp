#include "firmware/loop/loop.h"

#include <gtest/gtest.h>

#include <atomic>
#include <cstddef>
#include <memory>
#include <vector>

#include "shared/trace.h"
#include "tests/firmware/loop/loop_bench.h"
#include "tests/support/alloc_guard.h"

namespace isotouch::loop {
namespace {

TEST(Loop, RepliesStartTheTicksAndEachIsFresh) {
  Bench bench;
  bench.steps(1000);
  EXPECT_EQ(bench.stats.ticks.value(), 1000U);
  EXPECT_EQ(bench.stats.fresh.value(), 1000U);
  EXPECT_GE(bench.stats.by_reply.value(), 990U);
  EXPECT_EQ(bench.stats.late.value(), 0U);
  EXPECT_EQ(bench.stats.samples_lost.value(), 0U);
  EXPECT_EQ(bench.device.commands, 1000U);
  EXPECT_EQ(bench.clock.now_ns(), 1'000'000'000);
  EXPECT_EQ(bench.shown.get().arrival_ns, bench.clock.now_ns());
  EXPECT_EQ(bench.stats.round_trip.read().total, 1000U);
}

TEST(Loop, WithoutARepliesTheTickStartsWhenItIsDueAndTheSampleAges) {
  Bench bench;
  bench.steps(100);
  const std::int64_t before = bench.shown.get().start_ns;
  bench.device.mute = 3;
  for (std::uint16_t age = 0; age <= 3; ++age) {
    const TickRecord record = bench.step();
    EXPECT_EQ(record.in.fresh, age == 0);  // the command of the tick before the silence is answered still
    EXPECT_EQ(record.in.age, age);
    EXPECT_EQ(record.in.packet, encode(FalconReply{}));
    EXPECT_EQ(record.start_ns, before + (age + 1) * 1'000'000 + (age == 0 ? 0 : 250'000));
  }
  const TickRecord back = bench.step();
  EXPECT_TRUE(back.in.fresh);
  EXPECT_EQ(back.in.age, 0);
  EXPECT_EQ(bench.stats.stale.value(), 3U);
  EXPECT_EQ(bench.stats.largest_age.value(), 3U);
}

TEST(Loop, BeforeTheFirstReplyThereIsNoPacketAndTheWordsRest) {
  Bench bench;
  bench.device.mute = 1'000'000;
  bench.device.newest();
  Bench silent;
  for (int i = 0; i < 50; ++i) {
    const TickRecord record = bench.step();
    if (record.in.fresh) continue;  // the one question of the beginning
    EXPECT_EQ(record.out.commands, (std::array<std::int16_t, 3>{}));
  }
}

TEST(Loop, ATickFasterThanTheDeviceSeesStaleSamplesInBetween) {
  Bench bench({.period_ns = 100'000});
  bench.steps(100);
  const std::uint64_t fresh = bench.stats.fresh.value();
  bench.steps(10'000);
  EXPECT_NEAR(double(bench.stats.fresh.value() - fresh), 1000.0, 10.0);
  EXPECT_LE(bench.stats.largest_age.value(), 10U);
  EXPECT_EQ(bench.stats.late.value(), 0U);
}

TEST(Loop, ATickThatWaitsForItsOwnTimeIsNotStartedByTheReply) {
  Bench bench;
  bench.device.keeps_asking = true;  // four replies a tick: each is too early
  bench.device.latency_ns = 250'000;
  bench.device.grid_ns = 250'000;
  bench.steps(20);
  const std::uint64_t before = bench.stats.by_reply.value();
  bench.steps(1000);
  EXPECT_EQ(bench.stats.fresh.value(), 1020U);
  EXPECT_LE(bench.stats.by_reply.value() - before, 10U);
}

TEST(Loop, TheWatchdogIsToldEveryTicksState) {
  Bench bench;
  EXPECT_EQ(bench.lines.told(), SupervisorState::kBoot);
  bench.steps(20);
  EXPECT_EQ(bench.state(), SupervisorState::kHoming);
  EXPECT_EQ(bench.lines.told(), bench.state());
  bench.requests.ask(kRequestStop);
  bench.steps(1);
  EXPECT_EQ(bench.lines.told(), SupervisorState::kFault);
}

TEST(Loop, ATickSlowerThanTheDeviceTakesTheNewestSampleAndCountsTheOthers) {
  Bench bench({.period_ns = 4'000'000});
  bench.device.keeps_asking = true;
  bench.steps(1000);
  EXPECT_EQ(bench.stats.stale.value(), 0U);
  EXPECT_NEAR(double(bench.stats.samples_lost.value()), 3000.0, 40.0);
  EXPECT_LE(bench.clock.now_ns() - bench.shown.get().arrival_ns, 1'000'000);
  EXPECT_NEAR(double(bench.clock.now_ns()), 4e9 * 513 / 512, 1e7);
}

TEST(Loop, WhatPassesBeforeTheFirstTickMakesNothingLate) {
  Bench bench;
  bench.clock.sleep_until_ns(110'000'000);
  const std::atomic<bool> stop{false};
  bench.loop.run(stop, 5);
  EXPECT_EQ(bench.stats.late.value(), 0U);
  EXPECT_EQ(bench.stats.missed.value(), 0U);
}

TEST(Loop, ATickThatIsLateLeavesWholePeriodsOutAndSaysSo) {
  Bench bench;
  bench.steps(10);
  bench.device.mute = 1'000'000;
  bench.step();
  bench.device.stall_ns = 5'000'000;
  const TickRecord record = bench.step();
  EXPECT_EQ(bench.stats.late.value(), 1U);
  EXPECT_EQ(bench.stats.missed.value(), 5U);
  EXPECT_EQ(record.in.age, 6U) << "ages are counted in periods, ticked or not";
  EXPECT_EQ(bench.step().in.age, 7U);
  EXPECT_EQ(bench.stats.late.value(), 1U);
  EXPECT_EQ(bench.stats.wake_delay.read().largest_ns, 5'000'000U);
}

TEST(Loop, WhatIsLateAndWhatTheLinesTellEntersTheTick) {
  Bench bench;
  bench.steps(10);
  bench.device.stall_ns = 5'000'000;
  TickRecord record = bench.step();
  EXPECT_EQ(record.in.late, 5);
  EXPECT_NE(record.out.status & kLate, 0U);
  EXPECT_EQ(bench.step().in.late, 0);
  bench.device.stall_ns = 90'000'000;
  record = bench.step();
  EXPECT_EQ(record.in.late, kMaxLate);
  EXPECT_EQ(record.in.requests, 0);
  bench.device.stall_ns = 110'000'000;
  EXPECT_EQ(bench.step().in.requests, kRequestPaused) << "longer than a hold may last";
  record = bench.step();
  EXPECT_EQ(record.in.requests, 0);
  EXPECT_EQ(record.in.lines, 0);
  bench.lines.put(kLineStop);
  record = bench.step();
  EXPECT_EQ(record.in.lines, kLineStop);
  EXPECT_EQ(bench.state(), SupervisorState::kFault);
}

/// Until there may be force: the hand is beside the ball.
void make_active(Bench& bench) {
  bench.device.answer = [far = grip_at({11, 0, 0})](const Command&) { return far; };
  bench.load(ball());
  bench.steps(500);
  ASSERT_EQ(bench.state(), SupervisorState::kActive);
}

TEST(Loop, AHoldOfSeveralPausesLastsNoLongerThanOneOfOne) {
  Bench bench;
  make_active(bench);
  bench.device.stall_ns = 60'000'000;
  EXPECT_EQ(bench.step().in.requests, 0);
  ASSERT_EQ(bench.state(), SupervisorState::kHold);
  bench.device.stall_ns = 30'000'000;
  EXPECT_EQ(bench.step().in.requests, 0) << "90 ms";
  ASSERT_EQ(bench.state(), SupervisorState::kHold);
  bench.device.stall_ns = 20'000'000;
  EXPECT_EQ(bench.step().in.requests, kRequestPaused) << "110 ms and more";
  EXPECT_EQ(bench.state(), SupervisorState::kFault);
}

TEST(Loop, PausesWithForceBetweenThemAreNoLongHold) {
  Bench bench;
  make_active(bench);
  for (int n = 0; n < 5; ++n) {
    ASSERT_EQ(bench.state(), SupervisorState::kActive);
    bench.device.stall_ns = 60'000'000;
    EXPECT_EQ(bench.step().in.requests, 0);
    bench.steps(50);
  }
}

TEST(Loop, ARecordingBegunInAFaultDoesNotEndIt) {
  Bench bench;
  bench.requests.ask(kRequestStop);
  bench.steps(5);
  bench.requests.ask(kRequestRestart);
  EXPECT_EQ(bench.step().in.requests, kRequestRestart | kRequestStop);
  bench.steps(20);
  EXPECT_EQ(bench.state(), SupervisorState::kFault);
  bench.requests.ask(kRequestResume);
  EXPECT_NE(static_cast<SupervisorState>(bench.step().out.state), SupervisorState::kFault);
  bench.requests.ask(kRequestRestart);
  EXPECT_EQ(bench.step().in.requests, kRequestRestart);
}

TEST(Loop, AFaultKeepsItsNameThroughARestartUntilAPersonResumes) {
  Bench bench;
  bench.lines.put(kLineStop);
  EXPECT_EQ(bench.step().faults, kFaultEmergency);
  bench.lines.put(0);
  bench.requests.ask(kRequestRestart);
  TickRecord record = bench.step();
  EXPECT_EQ(record.out.faults, kFaultStopped) << "the tick has forgotten";
  EXPECT_EQ(record.faults, kFaultEmergency | kFaultStopped);
  EXPECT_EQ(bench.loop.faults(), record.faults);
  bench.requests.ask(kRequestResume);
  EXPECT_EQ(bench.step().faults, 0);
}

TEST(Loop, TheFaultsOfAnEarlierLoopStayUntilAPersonResumes) {
  LoopSettings settings;
  settings.faults = kFaultGuard;
  Bench bench(settings);
  EXPECT_EQ(bench.loop.faults(), kFaultGuard);
  bench.requests.ask(kRequestStop);
  EXPECT_EQ(bench.step().faults, kFaultGuard | kFaultStopped);
  bench.requests.ask(kRequestResume);
  EXPECT_EQ(bench.step().faults, 0);
}

TEST(Loop, ARecordingBegunInAPauseDoesNotHideIt) {
  Bench bench;
  make_active(bench);
  bench.requests.ask(kRequestRestart);
  bench.device.stall_ns = 200'000'000;
  EXPECT_EQ(bench.step().in.requests, kRequestRestart | kRequestPaused | kRequestStop);
  bench.steps(50);
  EXPECT_EQ(bench.state(), SupervisorState::kFault);
}

TEST(Loop, AnAgeDoesNotWrap) {
  Bench bench;
  bench.steps(3);
  bench.device.mute = 1'000'000;
  bench.step();
  bench.device.stall_ns = 100'000'000'000'000;
  EXPECT_EQ(bench.step().in.age, 0xFFFFU);
  EXPECT_EQ(bench.step().in.age, 0xFFFFU);
}

TEST(Loop, ARequestReachesOneTick) {
  Bench bench;
  bench.steps(5);
  bench.requests.ask(kRequestStop);
  bench.requests.ask(kRequestRestart);
  EXPECT_EQ(bench.step().in.requests, kRequestStop | kRequestRestart);
  EXPECT_EQ(bench.step().in.requests, 0);
}

TEST(Loop, TimeThatTheMachineHasSleptCountsAsAPause) {
  Bench bench;
  bench.clock.suspend(3'600'000'000'000);  // before the first tick
  bench.step();
  bench.steps(10);
  bench.clock.suspend(900'000);
  EXPECT_EQ(bench.step().in.late, 0);
  bench.clock.suspend(5'000'000);
  EXPECT_EQ(bench.step().in.late, 5);
  TickRecord record = bench.step();
  EXPECT_EQ(record.in.late, 0);
  EXPECT_EQ(record.in.requests, 0);
  bench.clock.suspend(3'600'000'000'000);
  record = bench.step();
  EXPECT_EQ(record.in.late, kMaxLate);
  EXPECT_EQ(record.in.requests, kRequestPaused) << "longer than a hold may last";
  bench.clock.suspend(-1'000'000'000);  // read in the middle of something
  EXPECT_EQ(bench.step().in.late, 0);
  bench.clock.suspend(1'000'000'000);
  EXPECT_EQ(bench.step().in.late, 0);
}

TEST(Loop, ATickNamesWhoeverChangedSomethingInIt) {
  Bench bench;
  EXPECT_EQ(bench.step().in.author, kNobody);
  bench.requests.ask(kRequestStop, author_of(1000));
  bench.requests.set({TickSetting::kFriction, 1000}, author_of(7));
  TickRecord record = bench.step();
  EXPECT_EQ(record.in.author, author_of(1000));
  EXPECT_EQ(record.in.change, SettingChange{}) << "a change of somebody else waits for a tick of its own";
  record = bench.step();
  EXPECT_EQ(record.in.author, author_of(7));
  EXPECT_EQ(record.in.change.setting, TickSetting::kFriction);
  bench.load(ball(), author_of(8));
  EXPECT_EQ(bench.step().in.author, author_of(8)) << "who sent the field";
  EXPECT_EQ(bench.step().in.author, kNobody) << "once";
  bench.requests.ask(kRequestRestart, author_of(9));
  EXPECT_EQ(bench.step().in.author, author_of(9)) << "who began a recording";
  EXPECT_EQ(bench.step().in.author, author_of(7)) << "whose setting is set again";
}

TEST(Loop, APatchIsToldToTheTickThatTakesItOver) {
  Bench bench;
  bench.load(ball());
  EXPECT_EQ(bench.step().in.requests, 0);
  bench.patch(ball(20.5), author_of(8));
  bench.requests.set({TickSetting::kFriction, 1000}, author_of(7));
  TickRecord record = bench.step();
  EXPECT_EQ(record.in.requests, kRequestMoved);
  EXPECT_EQ(record.in.moved_to, static_cast<std::uint32_t>(bench.fields.field().view->hash()));
  EXPECT_EQ(record.in.author, author_of(8));
  EXPECT_EQ(record.in.change, SettingChange{});
  EXPECT_TRUE(decode_record(encode(TraceRecord{record.in, record.out, 0, 0})));
  record = bench.step();
  EXPECT_EQ(record.in.requests, 0);
  EXPECT_EQ(record.in.moved_to, 0U);
  EXPECT_EQ(record.in.change.setting, TickSetting::kFriction) << "it waited";

  bench.patch(ball(20.4));  // by nobody who is known
  bench.requests.set({TickSetting::kFriction, 2000}, author_of(7));
  EXPECT_EQ(bench.step().in.change, SettingChange{});
  EXPECT_EQ(bench.step().in.change.setting, TickSetting::kFriction);
}

TEST(Loop, ATickThatForgetsTakesAPatchAsAnotherField) {
  Bench bench;
  bench.load(ball());
  bench.step();
  bench.patch(ball(20.5));
  bench.requests.ask(kRequestRestart);
  const TickRecord record = bench.step();
  EXPECT_EQ(record.in.requests, kRequestRestart);
  EXPECT_TRUE(decode_record(encode(TraceRecord{record.in, record.out, 0, 0})));
  bench.load(ball(20.6));
  EXPECT_EQ(bench.step().in.requests, 0);
}

TEST(Loop, PatchesUnderAHandAllocateNothing) {
  Bench bench;
  bench.load(ball());
  const std::vector<std::uint8_t> one = ball(20.3), other = ball(20.0);
  bench.steps(100);
  const test::AllocGuard guard;
  std::uint64_t counted = 0;
  for (int n = 0; n < 20; ++n) {
    bench.patch(n % 2 == 0 ? one : other);
    const std::uint64_t before = guard.count();
    for (int t = 0; t < 33; ++t) (void)bench.loop.step();
    counted += guard.count() - before;
  }
  EXPECT_EQ(counted, 0U);
}

TEST(Loop, ASettingChangesInOneTickAndAgainInTheTickAfterARestart) {
  Bench bench;
  const SettingChange friction = {TickSetting::kFriction, 1000};
  bench.requests.set(friction);
  EXPECT_EQ(bench.step().in.change, friction);
  EXPECT_EQ(bench.step().in.change, SettingChange{});
  bench.requests.ask(kRequestRestart);
  EXPECT_EQ(bench.step().in.change, SettingChange{}) << "this tick is told of the heat instead";
  EXPECT_EQ(bench.step().in.change, friction);
  EXPECT_EQ(bench.step().in.change, SettingChange{});
}

TEST(Loop, WordsFollowTheHandOnceAFieldIsLoaded) {
  Bench bench;
  bench.device.answer = [far = grip_at({11, 0, 0})](const Command&) { return far; };
  bench.steps(200);
  EXPECT_EQ(bench.state(), SupervisorState::kIdle);
  bench.load(ball());
  bench.steps(400);
  EXPECT_EQ(bench.state(), SupervisorState::kActive);
  EXPECT_EQ(bench.stats.field_swaps.value(), 1U);
  EXPECT_EQ(bench.fields.acknowledged(), 1U);
  EXPECT_EQ(bench.device.last.falcon.words, (std::array<std::int16_t, 3>{}));
  std::vector<FalconPacket> way;
  for (int i = 0; i < 300; ++i) way.push_back(grip_at({11.0 - 0.02 * i, 0, 0}));
  bench.device.answer = [&way, i = std::size_t{0}](const Command&) mutable { return way[std::min(i++, way.size() - 1)]; };
  bench.steps(300);
  const TickRecord record = bench.step();
  EXPECT_NE(record.out.status & kContact, 0U);
  EXPECT_GT(record.out.force.x, Newton::of(1.0));
  EXPECT_EQ(bench.device.last.falcon.words, record.out.commands);
  EXPECT_NE(bench.device.last.falcon.words, (std::array<std::int16_t, 3>{}));
  EXPECT_EQ(bench.device.last.falcon.flags, record.out.packet_flags);
  EXPECT_EQ(bench.device.last.tick, record.number);
}

TEST(Loop, AFullRingLosesRecordsAndNoTicks) {
  Bench bench({}, 16);
  bench.steps(100);
  EXPECT_EQ(bench.trace.lost(), 84U);
  EXPECT_EQ(bench.stats.ticks.value(), 100U);
  TickRecord record;
  for (std::uint64_t i = 1; i <= 16; ++i) {
    ASSERT_TRUE(bench.trace.pop(record));
    EXPECT_EQ(record.number, i);
  }
}

TEST(Loop, EndsWithTheDeviceOrWhenToldTo) {
  Bench bench;
  bench.device.end_after = 20;
  const std::atomic<bool> go{false}, stop{true};
  bench.loop.run(stop);
  EXPECT_EQ(bench.stats.ticks.value(), 0U);
  bench.loop.run(go);
  EXPECT_EQ(bench.stats.ticks.value(), 20U);
}

TEST(LoopHeavy, AMillionTicksAllocateNothing) {
  Bench bench;
  bench.load(ball());
  std::vector<FalconPacket> way;
  for (int i = 0; i < 2000; ++i) way.push_back(grip_at({9 - 3 * std::sin(i * 0.00314159), 2 * std::sin(i * 0.0251327), 0}));
  bench.device.answer = [&way, i = std::size_t{0}](const Command&) mutable { return way[i++ % way.size()]; };
  bench.steps(500);
  EXPECT_EQ(bench.state(), SupervisorState::kActive);
  TickRecord record;
  std::uint64_t contacts = 0;
  const test::AllocGuard guard;
  for (int i = 0; i < 1'000'000; ++i) {
    bench.loop.step();
    bench.trace.pop(record);
    contacts += record.out.status & kContact;
  }
  EXPECT_EQ(guard.count(), 0U);
  EXPECT_GT(contacts, 300'000U);
  EXPECT_EQ(bench.state(), SupervisorState::kActive);
}

/// Whoever begins a recording every second heats the motors no more than whoever begins none.
TEST(Loop, ALoopGoesOnWithTheHeatOfTheOneBefore) {
  Bench first;
  EXPECT_EQ(first.loop.heat(), 0U) << "not known";
  first.steps(1000);
  LoopSettings wish;
  wish.heat = first.loop.heat();
  EXPECT_GT(wish.heat, 0U);
  Bench second(wish);
  EXPECT_EQ(second.loop.heat(), wish.heat);
}

TEST(Loop, RecordingsDoNotMakeTheMotorsForgetTheirHeat) {
  constexpr int kSecond = 1000, kSeconds = 60;
  const auto mean_square = [](bool recording, std::vector<TickRecord>& last) {
    LoopSettings wish;
    wish.device.heat_word = 200;
    wish.device.heat_ms = 5000;
    Bench bench(wish);
    std::vector<FalconPacket> second;  // out, in, and a second in the object less that
    for (int t = 0; t < kSecond; ++t) second.push_back(grip_at({t < 300 ? 11.0 : std::max(11.0 - 0.05 * (t - 300), 5.0), 0, 0}));
    bench.device.answer = [&second, t = std::size_t{0}](const Command&) mutable { return second[t++ % second.size()]; };
    bench.load(ball());
    double sum = 0;
    for (int t = 0; t < kSecond * kSeconds; ++t) {
      if (recording && t % kSecond == 0) bench.requests.ask(kRequestRestart);
      const TickRecord record = bench.step();
      if (record.in.requests != 0) last.clear();
      last.push_back(record);
      if (t >= kSecond * 30) sum += double(record.out.commands[1]) * record.out.commands[1];
    }
    // What was recorded answers the same from the state before the first tick.
    const core::TickModel model = core::make_tick_model(wish.device, wish.tick, wish.period_ns);
    core::TickState fresh;
    const ActiveField field = bench.fields.published();
    for (const TickRecord& tick : last)
      EXPECT_EQ(core::tick(tick.in, tick.in.field_generation != 0 ? field.view : nullptr, model, fresh), tick.out);
    EXPECT_FALSE(last.empty());
    return sum / (kSecond * 30);
  };
  std::vector<TickRecord> last;
  const double once = mean_square(false, last);
  last.clear();
  const double often = mean_square(true, last);
  EXPECT_GT(once, 10'000) << "warm enough to be limited";
  EXPECT_LE(often, once * 1.02);
  EXPECT_GE(often, once * 0.8) << "nor does it take force away";
}

}  // namespace
}  // namespace isotouch::loop
