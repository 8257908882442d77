#include "firmware/loop/watchdog.h"

#include <gtest/gtest.h>

#include "firmware/loop/virtual_clock.h"
#include "tests/support/alloc_guard.h"
#include "tests/support/fake_lines.h"

namespace isotouch::loop {
namespace {

using S = SupervisorState;

struct Bench {
  VirtualClock clock;
  test::FakeLines lines{clock};
  LineState state;
  Counter ticks;
  Watchdog watch{{}, lines, clock, state, ticks};

  /// So many milliseconds, with or without ticks.
  void run(int ms, bool ticking = true) {
    for (int t = 0; t < ms; ++t) {
      if (ticking) ticks.add();
      watch.step();
    }
  }
  void in(S s) { state.tell(static_cast<std::uint16_t>(s)); }
};

TEST(Watchdog, PowerIsThereInReadyActiveAndHoldAlone) {
  for (const S s : {S::kBoot, S::kHoming, S::kIdle, S::kReady, S::kActive, S::kHold, S::kFault}) {
    Bench bench;
    bench.in(s);
    bench.run(5);
    EXPECT_EQ(bench.lines.out.enable, s == S::kReady || s == S::kActive || s == S::kHold);
    EXPECT_EQ(bench.state.get(), 0);
  }
}

TEST(Watchdog, WhenTicksStopPowerAndHeartbeatGo) {
  Bench bench;
  bench.in(S::kActive);
  bench.run(100);
  EXPECT_TRUE(bench.lines.out.enable);
  bench.run(20, false);
  EXPECT_TRUE(bench.lines.out.enable);
  bench.run(1, false);
  EXPECT_FALSE(bench.lines.out.enable);
  const bool beat = bench.lines.out.heartbeat;
  for (int t = 0; t < 50; ++t) {
    bench.run(1, false);
    EXPECT_EQ(bench.lines.out.heartbeat, beat);
  }
  bench.run(1);
  EXPECT_TRUE(bench.lines.out.enable);
}

TEST(Watchdog, TheHeartbeatChangesAtEveryStepWhileTicksCome) {
  Bench bench;
  bench.run(1);
  for (int t = 0; t < 100; ++t) {
    const bool before = bench.lines.out.heartbeat;
    bench.run(1);
    EXPECT_NE(bench.lines.out.heartbeat, before);
  }
}

TEST(Watchdog, ItsStepsStayOnTheirGridHoweverLongTheirWorkTakes) {
  Bench bench;
  for (int t = 1; t <= 1000; ++t) {
    bench.run(1);
    ASSERT_EQ(bench.clock.now_ns(), t * 1'000'000);
    bench.clock.sleep_until_ns(bench.clock.now_ns() + 300'000);
  }
  bench.clock.sleep_until_ns(bench.clock.now_ns() + 5'000'000);  // held up
  const std::int64_t held = bench.clock.now_ns();
  bench.run(1);
  EXPECT_EQ(bench.clock.now_ns(), held) << "at once";
  bench.run(1);
  EXPECT_EQ(bench.clock.now_ns(), held + 1'000'000) << "what was missed is not made up for";
}

TEST(Watchdog, EdgesThatEndWaitsEarlyDoNotPutOffTheNextLook) {
  Bench bench;
  bench.lines.edges_ns = 100'000;
  bench.run(10'000);
  bench.lines.edges_ns = 0;
  for (int t = 0; t < 10; ++t) {
    const std::int64_t before = bench.clock.now_ns();
    bench.run(1);
    ASSERT_EQ(bench.clock.now_ns() - before, 1'000'000) << "as if nothing had been";
  }
}

TEST(Watchdog, BeforeTheFirstTickThereIsNeither) {
  Bench bench;
  bench.in(S::kActive);
  bench.run(5, false);
  EXPECT_EQ(bench.lines.out.enable, false);
  EXPECT_EQ(bench.lines.out.heartbeat, false);
}

TEST(Watchdog, TheStopTakesThePowerInItsOwnStepAndIsTold) {
  Bench bench;
  bench.in(S::kActive);
  bench.run(10);
  bench.lines.pressed = true;
  bench.run(1);
  EXPECT_FALSE(bench.lines.out.enable) << "though the supervisor has not heard of it yet";
  EXPECT_EQ(bench.state.get(), kLineStop);
  EXPECT_EQ(bench.watch.stop_edge_ns(), bench.clock.now_ns());
  bench.lines.pressed = false;
  bench.run(10);
  EXPECT_EQ(bench.state.get(), kLineStop) << "the supervisor still has not";
  EXPECT_FALSE(bench.lines.out.enable);
  bench.in(S::kFault);
  bench.run(1);
  EXPECT_EQ(bench.state.get(), 0);
}

TEST(Watchdog, APressThatIsOverBeforeTheNextLookIsOneAllTheSame) {
  for (const S state : {S::kBoot, S::kHoming, S::kIdle, S::kReady, S::kActive, S::kHold}) {
    Bench bench;
    bench.in(state);
    bench.run(10);
    bench.lines.edge_ns = bench.clock.now_ns() + 300'000;
    bench.run(3);  // a slow tick hears of it late
    EXPECT_EQ(bench.state.get(), kLineStop) << static_cast<int>(state);
    bench.in(S::kFault);
    bench.run(1);
    EXPECT_EQ(bench.state.get(), 0) << "the supervisor has heard of it";
  }
}

TEST(Watchdog, AnEnableThatReadsBackWrongIsToldWhenItHadTimeToSettle) {
  for (const bool on : {false, true}) {
    Bench bench;
    bench.in(on ? S::kIdle : S::kActive);
    bench.run(10);
    (on ? bench.lines.stuck_on : bench.lines.stuck_off) = true;
    bench.run(50);
    EXPECT_EQ(bench.state.get(), 0);
    bench.run(2);
    EXPECT_EQ(bench.state.get(), kLineEnableWrong);
    EXPECT_FALSE(bench.lines.out.enable);
    bench.run(500);
    if (on) {
      EXPECT_EQ(bench.state.get(), kLineEnableWrong) << "as long as it is stuck";
    }
    bench.lines.stuck_on = bench.lines.stuck_off = false;
    bench.in(S::kFault);
    bench.run(2);
    EXPECT_EQ(bench.state.get(), 0);
  }
}

TEST(Watchdog, TheLightIsOnWithForcesAndBlinksInFault) {
  Bench bench;
  bench.in(S::kActive);
  bench.run(3);
  EXPECT_TRUE(bench.lines.out.light);
  bench.in(S::kFault);
  int lit = 0;
  for (int t = 0; t < 1000; ++t) {
    bench.run(1);
    lit += bench.lines.out.light ? 1 : 0;
  }
  EXPECT_NEAR(lit, 500, 2);
  bench.in(S::kIdle);
  bench.run(1);
  EXPECT_FALSE(bench.lines.out.light);
}

TEST(Watchdog, OneThatSaysNothingMoreIsAStop) {
  Bench bench;
  bench.state.set_patience(100);
  for (int t = 0; t < 1000; ++t) {
    bench.run(1);
    ASSERT_EQ(bench.state.get(), 0);
  }
  for (int t = 0; t < 100; ++t) ASSERT_EQ(bench.state.get(), 0) << t;
  for (int t = 0; t < 100; ++t) ASSERT_EQ(bench.state.get(), kLineStop) << t;
  bench.run(1);
  EXPECT_EQ(bench.state.get(), 0);
}

TEST(Watchdog, OneThatNeverBeganIsAStopToo) {
  LineState state;
  for (int t = 0; t < 1000; ++t) ASSERT_EQ(state.get(), 0) << "without lines nobody watches";
  state.set_patience(100);
  EXPECT_EQ(state.get(), kLineStop);
}

TEST(Watchdog, LeavesEverythingOffAndAllocatesNothing) {
  VirtualClock clock;
  test::FakeLines lines{clock};
  LineState state;
  Counter ticks;
  state.tell(static_cast<std::uint16_t>(S::kActive));
  {
    Watchdog watch{{}, lines, clock, state, ticks};
    const test::AllocGuard guard;
    for (int t = 0; t < 10; ++t) {
      ticks.add();
      watch.step();
    }
    EXPECT_EQ(guard.count(), 0U);
    EXPECT_TRUE(lines.out.enable);
  }
  EXPECT_EQ(lines.out, LineOutputs{});
}

}  // namespace
}  // namespace isotouch::loop
