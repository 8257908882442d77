/// What ends or limits forces, in the tick that shows it: missing and malformed packets, jumps, speed, depth, lines, lateness, warmth.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdlib>
#include <cstring>

#include "firmware/core/tick.h"
#include "tests/support/device_bench.h"

namespace isotouch::core {
namespace {

using test::kCentre;
using test::mm;
using test::newton;
using test::packet;
using test::Point;
using test::state_of;
using test::Words;
using Bench = test::DeviceBench;

TEST(DeviceTickStops, MissingPacketsHoldAndThenForcesReturnByARamp) {
  Bench bench;
  bench.begin();
  const Point inside = kCentre + Point{7, 0, 0};
  bench.press(7);
  const Output before = bench.rest(inside, 50);
  EXPECT_NEAR(newton(before.force).x, 0.8, 0.02);
  for (std::uint16_t age = 1; age <= 2; ++age) {
    const Output out = bench(bench.stale(age));
    EXPECT_EQ(out.commands, before.commands);
    EXPECT_TRUE(out.status & kStale);
  }
  Output out = bench(bench.stale(3));
  EXPECT_EQ(state_of(out), SupervisorState::kHold);
  EXPECT_EQ(out.commands, Words{});
  double last = 0;
  for (int t = 0; t < 200; ++t) {
    out = bench.at(inside);
    EXPECT_EQ(state_of(out), SupervisorState::kActive);
    const double force = newton(out.force).x;
    EXPECT_NEAR(force - last, 0.8 / 200, 0.0005);
    last = force;
  }
  EXPECT_EQ(bench.at(inside).commands, before.commands);
}

TEST(DeviceTickStops, SilenceIsAFaultUntilItIsResumed) {
  Bench bench;
  bench.begin();
  Output out;
  int ticks = 0;
  for (; state_of(out) != SupervisorState::kFault && ticks < 1000; ++ticks) out = bench(Input{});
  EXPECT_EQ(ticks, 101);
  EXPECT_EQ(out.faults, kFaultSilent);
  EXPECT_EQ(out.packet_flags, kFalconHoming | kFalconRed);
  Input resume = bench.stale(200);
  resume.requests = kRequestResume;
  EXPECT_EQ(state_of(bench(resume)), SupervisorState::kFault) << "its cause is still there";
  EXPECT_EQ(state_of(bench.rest(kCentre + Point{10, 0, 0}, 20)), SupervisorState::kFault);
  resume = packet(bench.counts_at(kCentre + Point{10, 0, 0}));
  resume.requests = kRequestResume;
  out = bench(resume);
  EXPECT_EQ(out.faults, 0);
  EXPECT_EQ(state_of(bench.rest(kCentre + Point{10, 0, 0}, 3)), SupervisorState::kActive);
}

TEST(DeviceTickStops, AMalformedPacketCountsAsNone) {
  Bench bench;
  bench.begin();
  const Vec3<Mm> known = bench.at(kCentre + Point{10, 0, 0}).hip;
  for (std::size_t at = 0; at < kFalconPacketBytes; ++at) {
    Input in = packet({900, -900, 0});
    in.packet[at] = 0;
    const Output out = bench(in);
    EXPECT_EQ(out.hip, known);
    EXPECT_EQ(out.status & (kBadReply | kStale), std::uint32_t{kBadReply} | kStale);
    EXPECT_EQ(bench.at(kCentre + Point{10, 0, 0}).status & (kBadReply | kStale), 0U);
  }
}

TEST(DeviceTickStops, AJumpUnderForcesIsAFaultAndThePoseIsSoughtAnew) {
  Bench bench;
  bench.begin();
  bench.press(7);
  Input in = packet({-1200, -1200, -1200});
  Output out = bench(in);
  EXPECT_TRUE(out.status & kCountJump);
  EXPECT_TRUE(out.status & kPoseUncertain);
  EXPECT_EQ(state_of(out), SupervisorState::kFault);
  EXPECT_EQ(out.faults, kFaultEncoders);
  EXPECT_EQ(out.commands, Words{});
  int ticks = 1;
  for (; (out.status & kPoseUncertain) != 0; ++ticks) out = bench(in);
  EXPECT_GE(ticks, 2);
  EXPECT_LE(ticks, 6);
  EXPECT_NEAR(mm(out.hip).z + 125, test::libnifalcon_twin().forward(test::libnifalcon_twin().angles_of({-1200, -1200, -1200}))->z, 0.00001);
}

TEST(DeviceTickStops, HomingLostBeginsAgainWhereverTheCountsWere) {
  for (const Point& place : {kCentre + Point{7, 0, 0}, Point{10, 0, -3}}) {
    Bench bench;
    bench.begin();
    for (double part = 0; part < 1; part += 0.01) bench.at((kCentre + Point{10, 0, 0}) * (1 - part) + place * part);
    Output out = bench(packet({0, 0, 0}, 0));  // the device began anew: its counts mean nothing
    EXPECT_EQ(state_of(out), SupervisorState::kHoming);
    EXPECT_EQ(out.commands, Words{});
    for (int t = 0; t < 10; ++t) out = bench(packet({0, 0, 0}, 6));
    EXPECT_EQ(state_of(out), SupervisorState::kHoming);
    EXPECT_EQ(out.faults, 0);
  }
}

TEST(DeviceTickStops, ALeapHoldsAtOnceAndAHandThatIsTooFastAsLongAsItIs) {
  Bench bench;
  bench.begin();
  bench.press(7);
  EXPECT_NE(bench.at(kCentre + Point{7, 0, 0}).commands, Words{});
  Output out = bench.at(kCentre + Point{2.9, 0, 0});  // 4.1 m/s, and no more than 250 counts
  EXPECT_FALSE(out.status & kCountJump);
  EXPECT_EQ(state_of(out), SupervisorState::kHold);
  EXPECT_EQ(out.commands, Words{});
  out = bench.rest(kCentre + Point{2.9, 0, 0}, 30);
  EXPECT_EQ(state_of(out), SupervisorState::kActive);
  EXPECT_TRUE(out.status & kRamping);
}

TEST(DeviceTickStops, BothEdgesOfTheLimits) {
  for (const std::int16_t counts : {std::int16_t{400}, std::int16_t{401}}) {  // of a jump
    Bench bench;
    bench.begin();
    Counts there = bench.counts_at(kCentre + Point{10, 0, 0});
    there[1] = static_cast<std::int16_t>(there[1] + counts);
    EXPECT_EQ((bench(packet(there)).status & kCountJump) != 0, counts > 400);
  }
  for (const double mm_a_tick : {1.97, 2.03}) {  // of the speed, 2 m/s, in free space
    Bench bench;
    bench.begin();
    bench.go_round({1, 0, 0}, {0, 0, 1});
    std::uint32_t status = 0;
    for (int t = 0; t < 25; ++t) status |= bench.at(kCentre + Point{0, -mm_a_tick * t, 10}).status;
    EXPECT_EQ((status & kTooFast) != 0, mm_a_tick > 2) << mm_a_tick;
  }
  for (const double depth : {3.9, 4.1}) {  // of the depth
    DeviceModel device = libnifalcon_model();
    device.penetration_limit = Mm::of(4);
    Bench bench(test::falcon_sets()[0], device);
    bench.begin();
    bench.press(8 - depth);
    EXPECT_EQ(state_of(bench.rest(kCentre + Point{8 - depth, 0, 0}, 5)) == SupervisorState::kFault, depth > 4);
  }
}

TEST(DeviceTickStops, LinesAndLatenessAreInputs) {
  for (const std::uint8_t line : {std::uint8_t{kLineStop}, std::uint8_t{kLineEnableWrong}}) {
    Bench bench;
    bench.begin();
    bench.press(7);
    Input in = packet(bench.counts_at(kCentre + Point{7, 0, 0}));
    in.lines = line;
    const Output out = bench(in);
    EXPECT_EQ(state_of(out), SupervisorState::kFault);
    EXPECT_EQ(out.commands, Words{});
    in.requests = kRequestResume;
    EXPECT_EQ(state_of(bench(in)), SupervisorState::kFault) << "still pressed";
    in.lines = 0;
    EXPECT_EQ(state_of(bench(in)), SupervisorState::kIdle);
  }
  Bench bench;
  bench.begin();
  bench.press(7);
  Input in = packet(bench.counts_at(kCentre + Point{7, 0, 0}));
  in.late = 2;
  Output out = bench(in);
  EXPECT_EQ(state_of(out), SupervisorState::kActive);
  EXPECT_TRUE(out.status & kLate);
  EXPECT_EQ(state_of(bench(in)), SupervisorState::kHold);
  in.late = 0;
  out = bench.rest(kCentre + Point{7, 0, 0}, 10);
  EXPECT_EQ(state_of(out), SupervisorState::kActive);
  EXPECT_TRUE(out.status & kRamping);
}

TEST(DeviceTickStops, WarmMotorsGiveLessAndSaySo) {
  DeviceModel device = libnifalcon_model();
  device.heat_word = 200;
  device.heat_ms = 5000;
  Bench bench(test::falcon_sets()[0], device);
  bench.begin();
  bench.press(6);
  EXPECT_GT(bench.at(kCentre + Point{6, 0, 0}).commands[1], 300);
  const Output out = bench.rest(kCentre + Point{6, 0, 0}, 30'000);
  EXPECT_EQ(state_of(out), SupervisorState::kActive) << "a limit is no fault";
  EXPECT_EQ(out.status & (kHeatLimited | kCommandsLimited), std::uint32_t{kHeatLimited} | kCommandsLimited);
  int most = 0;
  for (const std::int16_t word : out.commands) most = std::max(most, std::abs(int{word}));
  EXPECT_NEAR(most, 200, 5);
}

TEST(DeviceTickStops, TooDeepIsAFault) {
  DeviceModel device = libnifalcon_model();
  device.penetration_limit = Mm::of(2);
  Bench bench(test::falcon_sets()[0], device);
  bench.begin();
  double r = 10;
  Output out;
  for (; r > 5 && state_of(out) != SupervisorState::kFault; r -= 0.01) out = bench.at(kCentre + Point{r, 0, 0});
  EXPECT_EQ(out.faults, kFaultPenetration);
  EXPECT_NEAR(r, 6, 0.06);
  EXPECT_EQ(out.commands, Words{});
}

/// Damages one bit of what the supervisor remembers.
void flip(SupervisorMemory& memory, std::size_t bit) {
  std::array<std::uint8_t, sizeof(SupervisorMemory)> bytes{};
  std::memcpy(bytes.data(), &memory, sizeof memory);
  bytes[bit / 8] = static_cast<std::uint8_t>(bytes[bit / 8] ^ 1U << bit % 8);
  std::memcpy(static_cast<void*>(&memory), bytes.data(), sizeof memory);
}

TEST(DeviceTickStops, NoBitOfTheSupervisorEndsAFault) {
  Bench begun;
  begun.begin();
  begun.press(7);
  Input in = packet(begun.counts_at(kCentre + Point{7, 0, 0}));
  ASSERT_NE(begun(in).commands, Words{});
  in.requests = kRequestStop;
  ASSERT_EQ(begun(in).faults, kFaultStopped);
  in.requests = 0;
  for (std::size_t bit = 0; bit < 8 * sizeof(SupervisorMemory); ++bit) {
    Bench bench = begun;
    flip(bench.state.supervisor, bit);
    for (int t = 0; t < 100; ++t) {
      const Output out = bench(in);
      ASSERT_EQ(out.commands, Words{}) << "bit " << bit << " tick " << t << " state " << out.state << " faults " << out.faults;
      ASSERT_EQ(state_of(out), SupervisorState::kFault) << bit;
      ASSERT_NE(out.faults, 0) << bit;
    }
  }
}

TEST(DeviceTickStops, AFlippedBitOfTheStateIsAFaultOfItsOwn) {
  Bench begun;
  begun.begin();
  begun.press(7);
  const Input in = packet(begun.counts_at(kCentre + Point{7, 0, 0}));
  int noticed = 0;
  for (std::size_t bit = 0; bit < 8 * sizeof(SupervisorState) * 2; ++bit) {  // the state stands first, twice
    Bench bench = begun;
    flip(bench.state.supervisor, bit);
    const Output out = bench(in);
    EXPECT_EQ(out.commands, Words{}) << bit;
    EXPECT_EQ(out.faults, kFaultMemory) << bit;
    noticed += state_of(out) == SupervisorState::kFault ? 1 : 0;
  }
  EXPECT_EQ(noticed, 32);
}

TEST(DeviceTickStops, AFastHandIsTold) {
  Bench bench;
  bench.begin();
  std::uint32_t status = 0;
  for (int t = 0; t < 20; ++t) status |= bench.at(Point{-20 + 1.0 * t, 20, 0}).status;  // 1 m/s
  EXPECT_FALSE(status & kTooFast);
  bench.rest({-30, 25, 0}, 50);
  status = 0;
  for (int t = 0; t < 20; ++t) status |= bench.at(Point{-30 + 3.0 * t, 25, 0}).status;
  EXPECT_TRUE(status & kTooFast);
}

}  // namespace
}  // namespace isotouch::core
