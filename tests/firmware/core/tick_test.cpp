#include "firmware/core/tick.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <vector>

#include "tests/support/accuracy.h"
#include "tests/support/alloc_guard.h"
#include "tests/support/device_bench.h"

namespace isotouch::core {
namespace {

using test::FalconSet;
using test::kCentre;
using test::kOrigin;
using test::mm;
using test::newton;
using test::packet;
using test::Point;
using test::state_of;
using test::Words;
using Bench = test::DeviceBench;

TEST(DeviceTick, WakesUpStateByState) {
  Bench bench;
  Output out = bench(Input{});
  EXPECT_EQ(state_of(out), SupervisorState::kBoot);
  EXPECT_EQ(out.packet_flags, kFalconHoming | kFalconRed);
  for (int t = 0; t < 5; ++t) out = bench(packet({100, 200, 300}, 3));
  EXPECT_EQ(state_of(out), SupervisorState::kHoming);
  EXPECT_EQ(out.packet_flags, kFalconHoming | kFalconRed);
  int ticks = 0;
  for (; state_of(out) != SupervisorState::kIdle; ++ticks) out = bench.at({0, 0, 0});
  EXPECT_LE(ticks, 10);
  EXPECT_EQ(out.packet_flags, kFalconHoming | kFalconBlue);
  EXPECT_EQ(state_of(bench.rest({11, 0, 0}, 100)), SupervisorState::kIdle);
  bench.generation = 1;
  EXPECT_EQ(state_of(bench.at({11, 0, 0})), SupervisorState::kReady);
  out = bench.at({11, 0, 0});
  EXPECT_EQ(state_of(out), SupervisorState::kActive);
  EXPECT_EQ(out.packet_flags, kFalconHoming | kFalconGreen);
  EXPECT_EQ(out.faults, 0);
}

TEST(DeviceTick, InContactTheCommandsAreThoseOfTheTwin) {
  for (const FalconSet& set : test::falcon_sets()) {
    Bench bench(set, set.model);
    test::Random random(101);
    bench.begin();
    double worst_word = 0, worst_hip = 0;
    int compared = 0;
    for (int touch = 0; touch < 40; ++touch) {
      const Point n = random.direction();
      bench.go_round(touch == 0 ? Point{1, 0, 0} : Point{0, 0, 1}, n);
      for (double r = 10; r > 9; r -= 0.05) bench.at(kCentre + n * r);
      for (double r = 9; r > 5; r -= 0.02) {
        const Point hip = kCentre + n * r;
        const Output out = bench.at(hip);
        ASSERT_EQ(state_of(out), SupervisorState::kActive);
        const test::Angles angles = set.twin.angles_of(bench.counts_at(hip));
        const Point there = *set.twin.forward(angles, hip + kOrigin);
        worst_hip = std::max(worst_hip, test::length(mm(out.hip) + kOrigin - there));
        const test::Angles torques = set.twin.torques(there, angles, newton(out.force));
        for (std::size_t i = 0; i < 3; ++i) {
          const double exact = -torques[i] / set.twin.newton_mm_per_word;
          if ((out.status & (kCommandsLimited | kSlewLimited)) != 0) continue;
          worst_word = std::max(worst_word, std::abs(out.commands[i] - exact));
          ++compared;
        }
      }
      for (double r = 5; r < 10; r += 0.05) bench.at(kCentre + n * r);
      bench.go_round(n, Point{0, 0, 1});
    }
    EXPECT_GT(compared, 20'000) << set.name;
    EXPECT_THAT(worst_word, test::IsAccuracyOf(0.6)) << set.name;  // half is rounding
    EXPECT_THAT(worst_hip, test::IsAccuracyOf(0.0000032)) << set.name;
  }
}

TEST(DeviceTick, WordsAreZeroInEveryStateButActive) {
  Bench bench;
  test::Random random(102);
  int states[7] = {};
  Point hip = kCentre + Point{9, 0, 0};
  for (int t = 0; t < 200'000; ++t) {
    if (t % 997 == 0) bench.generation = t % 1994 == 0 ? bench.generation + 1 : 0;
    hip = kCentre + test::unit(hip + random.in_box(0.3) - kCentre) * (8 + 2 * std::sin(t * 0.01));
    Input in = packet(bench.counts_at(hip), t % 5000 < 20 ? 3 : 7);
    if (t % 5000 == 0) in.packet = encode(FalconReply{{-3000, 50, 3000}, 0, 0});
    const std::uint64_t dice = random.bits() % 2000;
    if (dice < 3) in.requests = kRequestStop;
    if (dice >= 3 && dice < 20) in.requests = kRequestResume;
    if (t % 300 > 294 || t % 20000 > 19800) in = bench.stale(1);
    const Output out = bench(in);
    ++states[out.state];
    if (state_of(out) == SupervisorState::kActive) continue;
    ASSERT_EQ(out.commands, Words{}) << t;
    ASSERT_EQ(out.force, Vec3<Newton>{}) << t;
  }
  for (int i = 1; i < 7; ++i) EXPECT_GT(states[i], 20) << i;
  EXPECT_GT(states[4], 10'000);
}

TEST(DeviceTick, HomedBitsThatAreDroppedLaterChangeNothing) {
  Bench bench;
  bench.begin();
  const Counts counts = bench.counts_at(kCentre + Point{10, 0, 0});
  for (int t = 0; t < 100; ++t) EXPECT_EQ(state_of(bench(packet(counts, 0))), SupervisorState::kActive);
}

TEST(DeviceTick, AnotherFieldBeginsAtTheHipWithARamp) {
  Bench bench;
  bench.begin();
  bench.press(7);
  EXPECT_GT(newton(bench.at(kCentre + Point{7, 0, 0}).force).x, 0.7);
  bench.generation = 2;
  Output out = bench.at(kCentre + Point{7, 0, 0});
  EXPECT_EQ(state_of(out), SupervisorState::kActive);
  EXPECT_EQ(out.commands, Words{});
  EXPECT_EQ(out.proxy, out.hip);
  EXPECT_TRUE(out.status & kHeldInside);
  for (double r = 7; r < 10; r += 0.05) EXPECT_EQ(bench.at(kCentre + Point{r, 0, 0}).commands, Words{});
  out = bench.press(7);
  EXPECT_TRUE(out.status & kRamping);
  out = bench.rest(kCentre + Point{7, 0, 0}, 200);
  EXPECT_EQ(out.status, std::uint32_t{kContact});
}

TEST(DeviceTick, APatchedFieldGoesOnBeingFelt) {
  for (const bool moved : {true, false}) {
    Bench bench;
    bench.begin();
    bench.press(6);
    const Point hand = kCentre + Point{6, 0, 0};
    const Point before = newton(bench.rest(hand, 100).force);
    ASSERT_GT(before.x, 1.0);
    bench.generation = 2;
    Input in = packet(bench.counts_at(hand));
    in.requests = moved ? kRequestMoved : 0;
    const Output out = bench(in);
    EXPECT_EQ(state_of(out), SupervisorState::kActive);
    EXPECT_EQ((out.status & kLagging) != 0, moved);
    EXPECT_EQ(length(newton(out.force) - before) < 0.05, moved);
    const Output later = bench.rest(hand, 100);
    EXPECT_EQ(later.status & kLagging, 0U);
    EXPECT_EQ(length(newton(later.force) - before) < 0.05, moved) << "another field begins with the hand inside";
  }
}

TEST(DeviceTick, APatchOfNoFieldIsAnotherField) {
  Bench bench;
  bench.rest(kCentre + Point{10, 0, 0}, 240);
  bench.generation = 1;
  Input in = packet(bench.counts_at(kCentre + Point{10, 0, 0}));
  in.requests = kRequestMoved;
  EXPECT_EQ(state_of(bench(in)), SupervisorState::kReady);
  EXPECT_FALSE(bench.state.render.coupling.lag.on);
}

TEST(DeviceTick, APatchDoesNotEndASettingsRamp) {
  Bench bench;
  bench.begin();
  bench.press(6);
  const Point hand = kCentre + Point{6, 0, 0};
  Input in = packet(bench.counts_at(hand));
  in.change = {TickSetting::kStiffness, Stiffness::of(0.2).raw()};
  bench(in);
  bench.rest(hand, 10);
  const Stiffness before = bench.state.felt.coupling.stiffness;
  bench.generation = 2;
  in = packet(bench.counts_at(hand));
  in.requests = kRequestMoved;
  bench(in);
  EXPECT_GT(bench.state.felt.coupling.stiffness, Stiffness::of(0.3));
  EXPECT_LT(bench.state.felt.coupling.stiffness, before);
}

/// A surface that rises past a hand is no hand that goes too deep.
TEST(DeviceTick, TheDepthIsJudgedAsFarAsItIsFelt) {
  DeviceModel device = test::falcon_sets()[0].model;
  device.penetration_limit = Mm::of(1.0);
  const auto ball_of = [](double radius) {
    return test::FieldImage({64, 64, 64},
                            [=](const Point& p) {
                              return (length(p * 0.4 - Point{12, 12, 12} - kCentre) - radius) / 0.4;
                            },
                            {.edge_mm = 0.4, .origin_mm = {-12, -12, -12}});
  };
  const test::FieldImage small = ball_of(8), large = ball_of(8.8);
  for (const bool moved : {true, false}) {
    Bench bench(test::falcon_sets()[0], device);
    bench.begin();
    bench.press(7.3);
    const Input in = packet(bench.counts_at(kCentre + Point{7.3, 0, 0}));
    Input patched = in;
    patched.field_generation = 2;
    if (moved) patched.requests = kRequestMoved;
    if (!moved) bench.state.field_generation = 2;  // as if nobody had said that it moved
    Output out = tick(patched, &large.view(), bench.model, bench.state);
    patched.requests = 0;
    for (int t = 0; t < 3; ++t) out = tick(patched, &large.view(), bench.model, bench.state);
    EXPECT_EQ(state_of(out) == SupervisorState::kFault, !moved);
  }
}

/// Not even on a surface that moves may a hand press as deep as it likes.
TEST(DeviceTick, AHandThatGoesTooDeepItselfIsStoppedWhileTheForceLags) {
  for (const bool moved : {true, false}) {
    DeviceModel device = test::falcon_sets()[0].model;
    device.penetration_limit = Mm::of(1.0);
    Bench bench(test::falcon_sets()[0], device);
    bench.begin();
    bench.press(7.3);
    Output out;
    double deepest = 0;
    for (double r = 7.3; r > 6.5 && state_of(out) != SupervisorState::kFault; r -= 0.05) {
      Input in = packet(bench.counts_at(kCentre + Point{r, 0, 0}));
      if (moved && deepest == 0) bench.generation = 2, in.requests = kRequestMoved;
      out = bench(in);
      deepest = 8 - r;
    }
    EXPECT_EQ(state_of(out), SupervisorState::kFault) << moved;
    EXPECT_EQ((out.status & kLagging) != 0, moved);
    EXPECT_NEAR(deepest, 1.0, 0.1) << moved;
  }
}

TEST(DeviceTick, ARestartForgetsEverything) {
  Bench used, fresh;
  used.begin();
  used.press(7);
  fresh.generation = used.generation;
  for (int t = 0; t < 300; ++t) {
    Input in = packet(used.counts_at(kCentre + Point{8.5 + std::sin(t * 0.02), 0, 0}));
    in.requests = t == 0 ? kRequestRestart : 0;
    ASSERT_EQ(used(in), fresh(in)) << t;
  }
  EXPECT_EQ(state_of(used.at(kCentre + Point{10, 0, 0})), SupervisorState::kActive);
}

TEST(DeviceTick, AllocatesNothing) {
  Bench bench;
  bench.begin();
  std::vector<Input> inputs;
  test::Random random(103);
  for (int i = 0; i < 2000; ++i) inputs.push_back(packet(bench.counts_at(random.in_ball(14))));
  const test::AllocGuard guard;
  for (int round = 0; round < 20; ++round) {
    for (const Input& in : inputs) bench(in);
  }
  EXPECT_EQ(guard.count(), 0U);
}

TEST(DeviceTick, ASettingThatChangesInContactChangesTheForceByARamp) {
  Bench bench;
  bench.begin();
  const Point inside = kCentre + Point{7, 0, 0};
  bench.press(7);
  bench.rest(inside, 50);
  const double before = newton(bench.at(inside).force).x;
  Input in = packet(bench.counts_at(inside));
  in.change = {TickSetting::kStiffness, Stiffness::of(1.2).raw()};
  double last = before;
  for (int t = 0; t < 50; ++t) {
    const double force = newton(bench(in).force).x;
    EXPECT_NEAR(force - last, before * 0.5 / 50, 0.0005) << t;
    last = force;
    in.change = {};
  }
  EXPECT_NEAR(last, 1.5 * before, 0.0005);
  EXPECT_EQ(newton(bench.at(inside).force).x, last);
  bench.generation = 2;  // another field keeps what was set
  bench.press(7);
  EXPECT_NEAR(newton(bench.rest(inside, 300).force).x, 1.5 * before, 0.001);
  in = packet(bench.counts_at(inside));
  in.requests = kRequestRestart;  // a recording that begins here has the settings of its header
  bench(in);
  bench.rest(kCentre + Point{10, 0, 0}, 240);
  bench.press(7);
  EXPECT_NEAR(newton(bench.rest(inside, 50).force).x, before, 0.001);
}

TEST(DeviceTick, TheHandleIsHeldUpWhileThereMayBeForcesOnly) {
  TickSettings settings;
  settings.weight = Newton::of(0.8);
  Bench bench(test::falcon_sets()[0], test::falcon_sets()[0].model, settings);
  EXPECT_EQ(bench.rest({11, 0, 0}, 100).commands, Words{});
  bench.begin();
  const Output out = bench.at(kCentre + Point{10, 0, 0});
  EXPECT_EQ(out.force, (Vec3<Newton>{{}, Newton::of(0.8), {}}));
  EXPECT_NE(out.commands, Words{});
}

/// Each line of a cold cache is a trip to memory; see "A cold tick" in DESIGN.md.
TEST(DeviceTick, ItsOwnDataAreFewCacheLines) {
  constexpr std::size_t kLine = 64, kStateLines = 12, kModelLines = 6;
  EXPECT_LE(sizeof(TickState), kStateLines * kLine);
  EXPECT_GT(sizeof(TickState), (kStateLines - 3) * kLine) << "they have become fewer: lower the bound";
  EXPECT_LE(sizeof(TickModel), kModelLines * kLine);
  EXPECT_GT(sizeof(TickModel), (kModelLines - 3) * kLine) << "they have become fewer: lower the bound";
}

}  // namespace
}  // namespace isotouch::core
