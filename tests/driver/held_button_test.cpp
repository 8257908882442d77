/// Tick and guard about a button that must be held.
#include <gtest/gtest.h>

#include <cstdint>
#include <random>
#include <utility>

#include "firmware/core/supervisor.h"
#include "firmware/guard/guard.h"
#include "shared/falcon_packet.h"
#include "shared/fault_names.h"

namespace isotouch::guard {
namespace {

constexpr std::uint32_t kPeriod = 1'000'000;

/// A tick that gives force exactly when its supervisor allows it, with a button that must be held, and a guard that hears the same packets.
class HeldButton : public ::testing::Test {
 protected:
  /// Packets that all show the same, a tick each.
  void show(bool pressed, int packets) {
    for (int n = 0; n < packets; ++n) {
      now_ns_ += kPeriod;
      stale_ = 0;
      guard_.hear(encode(FalconReply{{0, 0, static_cast<std::int16_t>(++heard_ % 2)}, pressed ? kButton : std::uint8_t{0}, 7}), now_ns_,
                  memory_);
      buttons_ = pressed ? kButton : 0;
      tick();
    }
  }
  void say_nothing(std::uint32_t ticks) {
    for (std::uint32_t t = 0; t < ticks; ++t) {
      now_ns_ += kPeriod;
      ++stale_;
      tick();
    }
  }
  void tick() {
    core::Observations seen;
    seen.heard = seen.homed = seen.pose_settled = seen.has_field = true;
    seen.stale_ticks = stale_;
    seen.buttons = buttons_;
    const bool granted = core::supervise(seen, core::make_supervision(device_, kPeriod), supervisor_).granted;
    felt_ += granted ? 1 : 0;
    loop::Command command;
    command.tick = ++tick_;
    command.sample = heard_;
    command.falcon.words.fill(static_cast<std::int16_t>(granted ? 1 + tick_ % 2 : 0));
    command.falcon.flags = device_.led_active;
    Evidence evidence;
    evidence.now_ns = now_ns_ + kPeriod / 2;
    (void)guard_.judge(command, evidence, memory_);
  }
  GuardVerdict verdict() const { return memory_.verdict; }
  int felt() { return std::exchange(felt_, 0); }

  static constexpr std::uint8_t kButton = 4;
  const DeviceModel device_ = [] {
    DeviceModel device = libnifalcon_model();
    device.buttons = kButton;
    device.hold_to_run = 1;
    return device;
  }();
  const Guard guard_{device_, kPeriod};
  Memory memory_;
  core::SupervisorMemory supervisor_;
  std::int64_t now_ns_ = 1;
  std::uint64_t tick_ = 0, heard_ = 0;
  std::uint32_t stale_ = 0;
  std::uint8_t buttons_ = 0;
  int felt_ = 0;
};

TEST_F(HeldButton, ThatBouncesIsNoReasonToStopATickThatForgetsItLater) {
  for (int open = 1; open <= 24; ++open) {
    show(true, 40);
    EXPECT_GT(felt(), 20) << open;
    show(false, open);
    (void)felt();
    show(true, 7);
    EXPECT_EQ(felt() > 0, open < core::kSteadyPackets) << open;
    ASSERT_EQ(verdict(), GuardVerdict::kNone) << open << ' ' << name_of(verdict());
  }
  std::mt19937 random(1);
  for (int n = 0; n < 20'000; ++n) {
    show(random() % 2 == 0, static_cast<int>(1 + random() % 12));
    ASSERT_EQ(verdict(), GuardVerdict::kNone) << n << ' ' << name_of(verdict());
  }
  EXPECT_GT(felt(), 10'000);
}

TEST_F(HeldButton, ThatNobodyKnowsAfterASilenceIsNoReasonToStopATickThatStillKnowsIt) {
  const std::uint32_t longest = core::make_supervision(device_, kPeriod).fault_ticks;
  for (std::uint32_t silence = longest - 3; silence <= longest; ++silence) {
    show(true, 40);
    say_nothing(silence);
    show(true, 40);
    EXPECT_GT(felt(), 20) << silence;
    ASSERT_EQ(verdict(), GuardVerdict::kNone) << silence << ' ' << name_of(verdict());
  }
}

}  // namespace
}  // namespace isotouch::guard
