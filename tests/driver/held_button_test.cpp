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
  /// Ticks with fresh packets, which all show the same.
  void show(bool pressed, int ticks) {
    for (int n = 0; n < ticks; ++n) {
      now_ns_ += kPeriod;
      for (int p = 0; p < packets_; ++p) hear(pressed);
      tick();
    }
  }
  void hear(bool pressed) {
    stale_ = 0;
    ++heard_;
    buttons_ = static_cast<std::uint8_t>((pressed ? kButton : 0) | (flickers_ && heard_ % 2 == 0 ? kAnother : 0));
    guard_.hear(encode(FalconReply{{0, 0, static_cast<std::int16_t>(heard_ % 2)}, buttons_, 7}), now_ns_, memory_);
  }
  void say_nothing(std::uint32_t ticks) {
    for (std::uint32_t t = 0; t < ticks; ++t) {
      now_ns_ += kPeriod;
      ++stale_;
      tick();
    }
  }
  /// What a tick gets that gives force whatever its supervisor says.
  GuardVerdict wrong_tick() {
    is_wrong_ = true;
    tick();
    is_wrong_ = false;
    return verdict();
  }
  void stop() {
    ++stops_;
    requests_ = kRequestStop;
    tick();
    requests_ = 0;
  }
  void tick() {
    core::Observations seen;
    seen.heard = seen.homed = seen.pose_settled = seen.has_field = true;
    seen.stale_ticks = stale_;
    seen.buttons = buttons_;
    seen.requests = requests_;
    const bool granted = core::supervise(seen, core::make_supervision(device_, kPeriod), supervisor_).granted || is_wrong_;
    felt_ += granted ? 1 : 0;
    loop::Command command;
    command.tick = ++tick_;
    command.sample = heard_;
    command.falcon.words.fill(static_cast<std::int16_t>(granted ? 1 + tick_ % 2 : 0));
    command.falcon.flags = device_.led_active;
    Evidence evidence;
    evidence.now_ns = now_ns_ + kPeriod / 2;
    evidence.stops = stops_;
    evidence.stopped = stops_ != 0;  // only a button resumes
    (void)guard_.judge(command, evidence, memory_);
  }
  GuardVerdict verdict() const { return memory_.verdict; }
  int felt() { return std::exchange(felt_, 0); }

  static constexpr std::uint8_t kButton = 4, kAnother = 1;
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
  std::uint32_t stops_ = 0;
  std::uint8_t buttons_ = 0, requests_ = 0;
  int packets_ = 1;        ///< in a tick
  bool flickers_ = false;  ///< a button that does not count
  bool is_wrong_ = false;
  int felt_ = 0;
};

TEST_F(HeldButton, ThatBouncesIsNoReasonToStopATickThatForgetsItLater) {
  std::mt19937 random(1);
  for (const int packets : {1, 2, 3, 4}) {
    packets_ = packets;
    for (int open = 1; open <= 24; ++open) {
      show(true, 40);
      EXPECT_GT(felt(), 20) << open;
      show(false, open);
      (void)felt();
      show(true, 7);
      EXPECT_EQ(felt() > 0, open < core::kSteadyPackets) << open;
      ASSERT_EQ(verdict(), GuardVerdict::kNone) << packets << ' ' << open << ' ' << name_of(verdict());
    }
    for (int n = 0; n < 20'000; ++n) {
      show(random() % 2 == 0, static_cast<int>(1 + random() % 12));
      ASSERT_EQ(verdict(), GuardVerdict::kNone) << packets << ' ' << n << ' ' << name_of(verdict());
    }
    EXPECT_GT(felt(), 10'000);
  }
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

TEST_F(HeldButton, ThatWasLetGoForSixteenTicksCountsOnlyAfterFourPackets) {
  for (const bool another_flickers : {false, true}) {
    flickers_ = another_flickers;
    for (const int pressed : {1, 3, 4}) {
      show(true, 40);
      ASSERT_EQ(verdict(), GuardVerdict::kNone) << name_of(verdict());
      show(false, 16);
      show(true, pressed - 1);
      now_ns_ += kPeriod;
      hear(true);
      EXPECT_EQ(wrong_tick(), pressed < 4 ? GuardVerdict::kReleased : GuardVerdict::kNone) << pressed;
      memory_.verdict = GuardVerdict::kNone;
    }
  }
}

TEST_F(HeldButton, IsForgottenInASilence) {
  const core::Supervision limits = core::make_supervision(device_, kPeriod);
  show(true, 40);
  say_nothing(limits.fault_ticks + limits.hold_ticks + 5);
  now_ns_ += kPeriod;
  hear(true);
  EXPECT_EQ(wrong_tick(), GuardVerdict::kReleased);
}

TEST_F(HeldButton, AfterASilenceEndsNoStopForTickAndGuard) {
  const core::Supervision limits = core::make_supervision(device_, kPeriod);
  show(false, 40);
  stop();
  say_nothing(limits.fault_ticks + limits.hold_ticks + 5);
  show(true, 40);
  EXPECT_EQ(felt(), 0);
  EXPECT_EQ(wrong_tick(), GuardVerdict::kStopped);
}

TEST_F(HeldButton, ThatIsPressedWhileTheTickStandsStillEndsAStopForBoth) {
  show(false, 40);
  stop();
  hear(false);
  now_ns_ += 3 * std::int64_t{device_.fault_age_ns};
  tick();
  show(true, 40);
  EXPECT_GT(felt(), 20);
  EXPECT_EQ(verdict(), GuardVerdict::kNone) << name_of(verdict());
}

}  // namespace
}  // namespace isotouch::guard
