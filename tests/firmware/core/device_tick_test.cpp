#include "firmware/core/device_tick.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <vector>

#include "tests/support/alloc_guard.h"
#include "tests/support/falcon_twin.h"
#include "tests/support/field_image.h"

namespace isotouch::core {
namespace {

using test::FalconSet;
using test::FieldImage;
using test::Point;
using Words = std::array<std::int16_t, 3>;

constexpr Point kCentre = {2, -1, 3};  // workspace, mm, of a ball of 8 mm
constexpr Point kOrigin = {0, 0, 125};

const FieldImage& ball() {
  static const FieldImage image({64, 64, 64},
                                [](const Point& p) {
                                  const Point mm = p * 0.4 - Point{12, 12, 12};
                                  return (test::length(mm - kCentre) - 8.0) / 0.4;
                                },
                                {.edge_mm = 0.4, .origin_mm = {-12, -12, -12}});
  return image;
}

Point mm(const Vec3<Mm>& v) { return {v.x.raw() / 1048576.0, v.y.raw() / 1048576.0, v.z.raw() / 1048576.0}; }
Point newton(const Vec3<Newton>& v) { return {v.x.raw() / 65536.0, v.y.raw() / 65536.0, v.z.raw() / 65536.0}; }
SupervisorState state_of(const DeviceOutput& out) { return static_cast<SupervisorState>(out.tick.state); }

DeviceInput packet(const Counts& counts, std::uint8_t homed = 7, std::uint8_t buttons = 0) {
  DeviceInput in;
  in.packet = encode(FalconReply{counts, buttons, homed});
  in.fresh = true;
  return in;
}

/// A device whose hand is put where one likes.
struct Bench {
  explicit Bench(const FalconSet& which = test::falcon_sets()[0], DeviceModel device = test::falcon_sets()[0].model,
                 const TickSettings& settings = {})
      : set(which), model(make_device_model(device, settings, 1'000'000)) {}

  Counts counts_at(const Point& workspace) const { return test::nearest_counts(set.twin, workspace + kOrigin, 3000).value(); }
  DeviceOutput operator()(DeviceInput in) {
    in.field_generation = generation;
    return device_tick(in, generation == 0 ? nullptr : &ball().view(), model, state);
  }
  DeviceOutput at(const Point& workspace) { return (*this)(packet(counts_at(workspace))); }
  DeviceOutput rest(const Point& workspace, int ticks) {
    DeviceOutput out;
    for (int t = 0; t < ticks; ++t) out = at(workspace);
    return out;
  }
  /// Around the ball, 2 mm above it, from one direction to another.
  void go_round(const Point& from, const Point& to) {
    for (int t = 0; t <= 60; ++t) at(kCentre + test::unit(from * (60.0 - t) + to * t) * 10);
  }
  /// Homed, with the field, active, ramp done, beside the ball.
  void begin() {
    generation = 1;
    ASSERT_EQ(state_of(rest(kCentre + Point{10, 0, 0}, 240)), SupervisorState::kActive);
  }
  DeviceInput stale(std::uint16_t age) const {
    DeviceInput in;
    in.age = age;
    return in;
  }

  FalconSet set;
  DeviceTickModel model;
  DeviceState state;
  std::uint32_t generation = 0;
};

TEST(DeviceTick, WakesUpStateByState) {
  Bench bench;
  DeviceOutput out = bench(DeviceInput{});
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

TEST(DeviceTick, InContactTheWordsAreThoseOfTheTwin) {
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
        const DeviceOutput out = bench.at(hip);
        ASSERT_EQ(state_of(out), SupervisorState::kActive);
        const test::Angles angles = set.twin.angles_of(bench.counts_at(hip));
        const Point there = *set.twin.forward(angles, hip + kOrigin);
        worst_hip = std::max(worst_hip, test::length(mm(out.hip) + kOrigin - there));
        const test::Angles torques = set.twin.torques(there, angles, newton(out.tick.force));
        for (std::size_t i = 0; i < 3; ++i) {
          const double exact = -torques[i] / set.twin.newton_mm_per_word;
          if ((out.tick.status & (kWordsLimited | kSlewLimited)) != 0) continue;
          worst_word = std::max(worst_word, std::abs(out.tick.words[i] - exact));
          ++compared;
        }
      }
      for (double r = 5; r < 10; r += 0.05) bench.at(kCentre + n * r);
      bench.go_round(n, Point{0, 0, 1});
    }
    EXPECT_GT(compared, 20'000) << set.name;
    EXPECT_LT(worst_word, 0.6) << set.name;  // half is rounding
    EXPECT_GT(worst_word, 0.4) << set.name;
    EXPECT_LT(worst_hip, 0.000005) << set.name;
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
    DeviceInput in = packet(bench.counts_at(hip), t % 5000 < 20 ? 3 : 7);
    if (t % 5000 == 0) in.packet = encode(FalconReply{{-3000, 50, 3000}, 0, 0});
    const std::uint64_t dice = random.bits() % 2000;
    if (dice < 3) in.commands = kCommandStop;
    if (dice >= 3 && dice < 20) in.commands = kCommandResume;
    if (t % 300 > 294 || t % 20000 > 19800) in = bench.stale(1);
    const DeviceOutput out = bench(in);
    ++states[out.tick.state];
    if (state_of(out) == SupervisorState::kActive) continue;
    ASSERT_EQ(out.tick.words, Words{}) << t;
    ASSERT_EQ(out.tick.force, Vec3<Newton>{}) << t;
  }
  for (int i = 1; i < 7; ++i) EXPECT_GT(states[i], 20) << i;
  EXPECT_GT(states[4], 10'000);
}

TEST(DeviceTick, MissingPacketsHoldAndThenForcesReturnByARamp) {
  Bench bench;
  bench.begin();
  const Point inside = kCentre + Point{7, 0, 0};
  for (double r = 10; r > 7; r -= 0.05) bench.at(kCentre + Point{r, 0, 0});
  const DeviceOutput before = bench.rest(inside, 50);
  EXPECT_NEAR(newton(before.tick.force).x, 0.8, 0.02);
  for (std::uint16_t age = 1; age <= 2; ++age) {
    const DeviceOutput out = bench(bench.stale(age));
    EXPECT_EQ(out.tick.words, before.tick.words);
    EXPECT_TRUE(out.tick.status & kStale);
  }
  DeviceOutput out = bench(bench.stale(3));
  EXPECT_EQ(state_of(out), SupervisorState::kHold);
  EXPECT_EQ(out.tick.words, Words{});
  double last = 0;
  for (int t = 0; t < 200; ++t) {
    out = bench.at(inside);
    EXPECT_EQ(state_of(out), SupervisorState::kActive);
    const double force = newton(out.tick.force).x;
    EXPECT_NEAR(force - last, 0.8 / 200, 0.0005);
    last = force;
  }
  EXPECT_EQ(bench.at(inside).tick.words, before.tick.words);
}

TEST(DeviceTick, SilenceIsAFaultUntilItIsResumed) {
  Bench bench;
  bench.begin();
  DeviceOutput out;
  int ticks = 0;
  for (; state_of(out) != SupervisorState::kFault && ticks < 1000; ++ticks) out = bench(DeviceInput{});
  EXPECT_EQ(ticks, 101);
  EXPECT_EQ(out.faults, kFaultSilent);
  EXPECT_EQ(out.packet_flags, kFalconHoming | kFalconRed);
  DeviceInput resume = bench.stale(200);
  resume.commands = kCommandResume;
  EXPECT_EQ(state_of(bench(resume)), SupervisorState::kFault) << "its cause is still there";
  EXPECT_EQ(state_of(bench.rest(kCentre + Point{10, 0, 0}, 20)), SupervisorState::kFault);
  resume = packet(bench.counts_at(kCentre + Point{10, 0, 0}));
  resume.commands = kCommandResume;
  out = bench(resume);
  EXPECT_EQ(out.faults, 0);
  EXPECT_EQ(state_of(bench.rest(kCentre + Point{10, 0, 0}, 3)), SupervisorState::kActive);
}

TEST(DeviceTick, AMalformedPacketCountsAsNone) {
  Bench bench;
  bench.begin();
  const Vec3<Mm> known = bench.at(kCentre + Point{10, 0, 0}).hip;
  for (std::size_t at = 0; at < kFalconPacketBytes; ++at) {
    DeviceInput in = packet({900, -900, 0});
    in.packet[at] = 0;
    const DeviceOutput out = bench(in);
    EXPECT_EQ(out.hip, known);
    EXPECT_EQ(out.tick.status & (kBadReply | kStale), std::uint32_t{kBadReply} | kStale);
    EXPECT_EQ(bench.at(kCentre + Point{10, 0, 0}).tick.status & (kBadReply | kStale), 0U);
  }
}

TEST(DeviceTick, AJumpUnderForcesIsAFaultAndThePoseIsSoughtAnew) {
  Bench bench;
  bench.begin();
  for (double r = 10; r > 7; r -= 0.05) bench.at(kCentre + Point{r, 0, 0});
  DeviceInput in = packet({-1200, -1200, -1200});
  DeviceOutput out = bench(in);
  EXPECT_TRUE(out.tick.status & kCountJump);
  EXPECT_TRUE(out.tick.status & kPoseUncertain);
  EXPECT_EQ(state_of(out), SupervisorState::kFault);
  EXPECT_EQ(out.faults, kFaultEncoders);
  EXPECT_EQ(out.tick.words, Words{});
  int ticks = 1;
  for (; (out.tick.status & kPoseUncertain) != 0; ++ticks) out = bench(in);
  EXPECT_GE(ticks, 2);
  EXPECT_LE(ticks, 6);
  EXPECT_NEAR(mm(out.hip).z + 125, test::libnifalcon_twin().forward(test::libnifalcon_twin().angles_of({-1200, -1200, -1200}))->z, 0.00001);
}

TEST(DeviceTick, HomingLostBeginsAgainWhereverTheCountsWere) {
  for (const Point& place : {kCentre + Point{7, 0, 0}, Point{10, 0, -3}}) {
    Bench bench;
    bench.begin();
    for (double part = 0; part < 1; part += 0.01) bench.at((kCentre + Point{10, 0, 0}) * (1 - part) + place * part);
    DeviceOutput out = bench(packet({0, 0, 0}, 0));  // the device began anew: its counts mean nothing
    EXPECT_EQ(state_of(out), SupervisorState::kHoming);
    EXPECT_EQ(out.tick.words, Words{});
    for (int t = 0; t < 10; ++t) out = bench(packet({0, 0, 0}, 6));
    EXPECT_EQ(state_of(out), SupervisorState::kHoming);
    EXPECT_EQ(out.faults, 0);
  }
}

TEST(DeviceTick, ALeapHoldsAtOnceAndAHandThatIsTooFastAsLongAsItIs) {
  Bench bench;
  bench.begin();
  for (double r = 10; r > 7; r -= 0.05) bench.at(kCentre + Point{r, 0, 0});
  EXPECT_NE(bench.at(kCentre + Point{7, 0, 0}).tick.words, Words{});
  DeviceOutput out = bench.at(kCentre + Point{2.9, 0, 0});  // 4.1 m/s, and no more than 250 counts
  EXPECT_FALSE(out.tick.status & kCountJump);
  EXPECT_EQ(state_of(out), SupervisorState::kHold);
  EXPECT_EQ(out.tick.words, Words{});
  out = bench.rest(kCentre + Point{2.9, 0, 0}, 30);
  EXPECT_EQ(state_of(out), SupervisorState::kActive);
  EXPECT_TRUE(out.tick.status & kRamping);
}

TEST(DeviceTick, BothEdgesOfTheLimits) {
  for (const std::int16_t counts : {std::int16_t{400}, std::int16_t{401}}) {  // of a jump
    Bench bench;
    bench.begin();
    Counts there = bench.counts_at(kCentre + Point{10, 0, 0});
    there[1] = static_cast<std::int16_t>(there[1] + counts);
    EXPECT_EQ((bench(packet(there)).tick.status & kCountJump) != 0, counts > 400);
  }
  for (const double mm_a_tick : {1.97, 2.03}) {  // of the speed, 2 m/s, in free space
    Bench bench;
    bench.begin();
    bench.go_round({1, 0, 0}, {0, 0, 1});
    std::uint32_t status = 0;
    for (int t = 0; t < 25; ++t) status |= bench.at(kCentre + Point{0, -mm_a_tick * t, 10}).tick.status;
    EXPECT_EQ((status & kTooFast) != 0, mm_a_tick > 2) << mm_a_tick;
  }
  for (const double depth : {3.9, 4.1}) {  // of the depth
    DeviceModel device = libnifalcon_model();
    device.penetration_limit = Mm::of(4);
    Bench bench(test::falcon_sets()[0], device);
    bench.begin();
    for (double r = 10; r > 8 - depth; r -= 0.02) bench.at(kCentre + Point{r, 0, 0});
    EXPECT_EQ(state_of(bench.rest(kCentre + Point{8 - depth, 0, 0}, 5)) == SupervisorState::kFault, depth > 4);
  }
}

TEST(DeviceTick, LinesAndLatenessAreInputs) {
  for (const std::uint8_t line : {std::uint8_t{kLineStop}, std::uint8_t{kLineEnableWrong}}) {
    Bench bench;
    bench.begin();
    for (double r = 10; r > 7; r -= 0.05) bench.at(kCentre + Point{r, 0, 0});
    DeviceInput in = packet(bench.counts_at(kCentre + Point{7, 0, 0}));
    in.lines = line;
    const DeviceOutput out = bench(in);
    EXPECT_EQ(state_of(out), SupervisorState::kFault);
    EXPECT_EQ(out.tick.words, Words{});
    in.commands = kCommandResume;
    EXPECT_EQ(state_of(bench(in)), SupervisorState::kFault) << "still pressed";
    in.lines = 0;
    EXPECT_EQ(state_of(bench(in)), SupervisorState::kIdle);
  }
  Bench bench;
  bench.begin();
  for (double r = 10; r > 7; r -= 0.05) bench.at(kCentre + Point{r, 0, 0});
  DeviceInput in = packet(bench.counts_at(kCentre + Point{7, 0, 0}));
  in.late = 2;
  DeviceOutput out = bench(in);
  EXPECT_EQ(state_of(out), SupervisorState::kActive);
  EXPECT_TRUE(out.tick.status & kLate);
  EXPECT_EQ(state_of(bench(in)), SupervisorState::kHold);
  in.late = 0;
  out = bench.rest(kCentre + Point{7, 0, 0}, 10);
  EXPECT_EQ(state_of(out), SupervisorState::kActive);
  EXPECT_TRUE(out.tick.status & kRamping);
}

TEST(DeviceTick, WarmMotorsGiveLessAndSaySo) {
  DeviceModel device = libnifalcon_model();
  device.heat_word = 200;
  device.heat_ms = 5000;
  Bench bench(test::falcon_sets()[0], device);
  bench.begin();
  for (double r = 10; r > 6; r -= 0.05) bench.at(kCentre + Point{r, 0, 0});
  EXPECT_GT(bench.at(kCentre + Point{6, 0, 0}).tick.words[1], 300);
  const DeviceOutput out = bench.rest(kCentre + Point{6, 0, 0}, 30'000);
  EXPECT_EQ(state_of(out), SupervisorState::kActive) << "a limit is no fault";
  EXPECT_EQ(out.tick.status & (kHeatLimited | kWordsLimited), std::uint32_t{kHeatLimited} | kWordsLimited);
  int most = 0;
  for (const std::int16_t word : out.tick.words) most = std::max(most, std::abs(int{word}));
  EXPECT_NEAR(most, 200, 5);
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
  for (double r = 10; r > 7; r -= 0.05) bench.at(kCentre + Point{r, 0, 0});
  EXPECT_GT(newton(bench.at(kCentre + Point{7, 0, 0}).tick.force).x, 0.7);
  bench.generation = 2;
  DeviceOutput out = bench.at(kCentre + Point{7, 0, 0});
  EXPECT_EQ(state_of(out), SupervisorState::kActive);
  EXPECT_EQ(out.tick.words, Words{});
  EXPECT_EQ(out.tick.proxy, out.hip);
  EXPECT_TRUE(out.tick.status & kHeldInside);
  for (double r = 7; r < 10; r += 0.05) EXPECT_EQ(bench.at(kCentre + Point{r, 0, 0}).tick.words, Words{});
  for (double r = 10; r > 7; r -= 0.05) out = bench.at(kCentre + Point{r, 0, 0});
  EXPECT_TRUE(out.tick.status & kRamping);
  out = bench.rest(kCentre + Point{7, 0, 0}, 200);
  EXPECT_EQ(out.tick.status, std::uint32_t{kContact});
}

TEST(DeviceTick, TooDeepIsAFault) {
  DeviceModel device = libnifalcon_model();
  device.penetration_limit = Mm::of(2);
  Bench bench(test::falcon_sets()[0], device);
  bench.begin();
  double r = 10;
  DeviceOutput out;
  for (; r > 5 && state_of(out) != SupervisorState::kFault; r -= 0.01) out = bench.at(kCentre + Point{r, 0, 0});
  EXPECT_EQ(out.faults, kFaultPenetration);
  EXPECT_NEAR(r, 6, 0.06);
  EXPECT_EQ(out.tick.words, Words{});
}

TEST(DeviceTick, AFastHandIsTold) {
  Bench bench;
  bench.begin();
  std::uint32_t status = 0;
  for (int t = 0; t < 20; ++t) status |= bench.at(Point{-20 + 1.0 * t, 20, 0}).tick.status;  // 1 m/s
  EXPECT_FALSE(status & kTooFast);
  bench.rest({-30, 25, 0}, 50);
  status = 0;
  for (int t = 0; t < 20; ++t) status |= bench.at(Point{-30 + 3.0 * t, 25, 0}).tick.status;
  EXPECT_TRUE(status & kTooFast);
}

TEST(DeviceTick, ARestartForgetsEverything) {
  Bench used, fresh;
  used.begin();
  for (double r = 10; r > 7; r -= 0.05) used.at(kCentre + Point{r, 0, 0});
  fresh.generation = used.generation;
  for (int t = 0; t < 300; ++t) {
    DeviceInput in = packet(used.counts_at(kCentre + Point{8.5 + std::sin(t * 0.02), 0, 0}));
    in.commands = t == 0 ? kCommandRestart : 0;
    ASSERT_EQ(used(in), fresh(in)) << t;
  }
  EXPECT_EQ(state_of(used.at(kCentre + Point{10, 0, 0})), SupervisorState::kActive);
}

TEST(DeviceTick, AllocatesNothing) {
  Bench bench;
  bench.begin();
  std::vector<DeviceInput> inputs;
  test::Random random(103);
  for (int i = 0; i < 2000; ++i) inputs.push_back(packet(bench.counts_at(random.in_ball(14))));
  const test::AllocGuard guard;
  for (int round = 0; round < 20; ++round) {
    for (const DeviceInput& in : inputs) bench(in);
  }
  EXPECT_EQ(guard.count(), 0U);
}

TEST(DeviceTick, ASettingThatChangesInContactChangesTheForceByARamp) {
  Bench bench;
  bench.begin();
  const Point inside = kCentre + Point{7, 0, 0};
  for (double r = 10; r > 7; r -= 0.05) bench.at(kCentre + Point{r, 0, 0});
  bench.rest(inside, 50);
  const double before = newton(bench.at(inside).tick.force).x;
  DeviceInput in = packet(bench.counts_at(inside));
  in.change = {TickSetting::kStiffness, Stiffness::of(1.2).raw()};
  double last = before;
  for (int t = 0; t < 50; ++t) {
    const double force = newton(bench(in).tick.force).x;
    EXPECT_NEAR(force - last, before * 0.5 / 50, 0.0005) << t;
    last = force;
    in.change = {};
  }
  EXPECT_NEAR(last, 1.5 * before, 0.0005);
  EXPECT_EQ(newton(bench.at(inside).tick.force).x, last);
  bench.generation = 2;  // another field keeps what was set
  for (double r = 10; r > 7; r -= 0.05) bench.at(kCentre + Point{r, 0, 0});
  EXPECT_NEAR(newton(bench.rest(inside, 300).tick.force).x, 1.5 * before, 0.001);
  in = packet(bench.counts_at(inside));
  in.commands = kCommandRestart;  // a recording that begins here has the settings of its header
  bench(in);
  bench.rest(kCentre + Point{10, 0, 0}, 240);
  for (double r = 10; r > 7; r -= 0.05) bench.at(kCentre + Point{r, 0, 0});
  EXPECT_NEAR(newton(bench.rest(inside, 50).tick.force).x, before, 0.001);
}

TEST(DeviceTick, TheHandleIsHeldUpWhileThereMayBeForcesOnly) {
  TickSettings settings;
  settings.weight = Newton::of(0.8);
  Bench bench(test::falcon_sets()[0], test::falcon_sets()[0].model, settings);
  EXPECT_EQ(bench.rest({11, 0, 0}, 100).tick.words, Words{});
  bench.begin();
  const DeviceOutput out = bench.at(kCentre + Point{10, 0, 0});
  EXPECT_EQ(out.tick.force, (Vec3<Newton>{{}, Newton::of(0.8), {}}));
  EXPECT_NE(out.tick.words, Words{});
}

}  // namespace
}  // namespace isotouch::core
