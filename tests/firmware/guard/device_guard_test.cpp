#include "firmware/guard/device_guard.h"

#include <gtest/gtest.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <unistd.h>

#include <cstdint>

#include "shared/falcon_packet.h"
#include "shared/fault_names.h"

namespace isotouch::guard {
namespace {

constexpr std::uint32_t kMillisecond = 1'000'000;

/// A guard beside a hand at rest, to which sound commands come.
struct GuardedDevice {
  /// Motor commands that pass of this one of every leg, or one that differs by a unit.
  MotorCommands pass(int word) {
    loop::Command command;
    command.tick = command.sample = ++tick;
    command.falcon.words.fill(static_cast<std::int16_t>(word + static_cast<int>(tick % 2)));
    command.falcon.flags = device.led_active;
    guard.hear(encode(FalconReply{{0, 0, static_cast<std::int16_t>(tick % 2)}, 0, 7}), now_ns());
    return guard.pass(command, now_ns());
  }
  std::int64_t now_ns() const { return static_cast<std::int64_t>(tick) * kMillisecond; }
  void begin() {
    for (int t = 0; t < 3; ++t) static_cast<void>(pass(t % 2 - 1));  // none
    ASSERT_NE(pass(1), MotorCommands{}) << name_of(lines.verdict());
  }

  const DeviceModel device = libnifalcon_model();
  loop::FieldSlots fields{1 << 16};
  loop::Requests requests;
  loop::LineState lines;
  DeviceGuard guard{device, {}, kMillisecond, fields, requests, lines};
  std::uint64_t tick = 0;
};

TEST(DeviceGuard, WhatItCannotRememberDoesNotPass) {
  const int other = memfd_create("other", MFD_CLOEXEC), memory = dup(other);
  close(memory);  // the number that the guard's file gets
  GuardedDevice bench;
  ASSERT_NO_FATAL_FAILURE(bench.begin());
  ASSERT_EQ(dup2(other, memory), memory);  // the guard's own file stays mapped
  EXPECT_EQ(bench.pass(1), MotorCommands{});
  close(other);
}

TEST(DeviceGuard, WithoutMemoryNothingPasses) {
  rlimit before{};
  ASSERT_EQ(getrlimit(RLIMIT_NOFILE, &before), 0);
  const rlimit none{0, before.rlim_max};
  ASSERT_EQ(setrlimit(RLIMIT_NOFILE, &none), 0);
  GuardedDevice bench;
  ASSERT_EQ(setrlimit(RLIMIT_NOFILE, &before), 0);
  EXPECT_FALSE(bench.guard.is_ready());
  for (int t = 0; t < 5; ++t) EXPECT_EQ(bench.pass(1), MotorCommands{});
}

TEST(DeviceGuard, AWeightBelowZeroIsHeldUpToo) {
  for (const int weight : {0, -2, 2}) {
    GuardedDevice bench;
    bench.requests.set({TickSetting::kWeight, weight * Newton::of(1).raw()});
    ASSERT_NO_FATAL_FAILURE(bench.begin());
    EXPECT_EQ(bench.pass(400) != MotorCommands{}, weight != 0) << weight << ": " << name_of(bench.lines.verdict());
  }
}

}  // namespace
}  // namespace isotouch::guard
