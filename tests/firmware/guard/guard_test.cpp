#include "firmware/guard/guard.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>

#include "shared/falcon_packet.h"
#include "shared/fault_names.h"
#include "tests/support/device_bench.h"

namespace isotouch::guard {
namespace {

constexpr std::uint32_t kPeriod = 1'000'000;

/// A guard that hears packets of a hand at rest, and judges commands that are smaller than any force that is felt.
class Samples : public ::testing::Test {
 protected:
  /// A reply comes now; its number is `heard_`.
  void hear() { guard_.hear(encode(FalconReply{{0, 0, static_cast<std::int16_t>(++heard_ % 2)}, 0, 7}), now_ns_, memory_); }
  /// The next tick's command, computed from a sample.
  GuardVerdict judge(std::uint64_t sample, bool has_words) { return judge(sample, static_cast<int>(has_words ? 1 + tick_ % 2 : 0)); }
  GuardVerdict judge(std::uint64_t sample, int word, std::uint32_t field_generation = 0) {
    now_ns_ += kPeriod;
    loop::Command command;
    command.tick = ++tick_;
    command.sample = sample;
    command.field_generation = field_generation;
    command.falcon.words.fill(static_cast<std::int16_t>(word));
    command.falcon.flags = device_.led_active;
    Evidence evidence;
    evidence.now_ns = now_ns_;
    (void)guard_.judge(command, evidence, memory_);
    return memory_.verdict;
  }
  void SetUp() override {
    for (int i = 0; i < 100; ++i) {
      hear();
      ASSERT_EQ(judge(heard_, i > 2), GuardVerdict::kNone) << name_of(memory_.verdict);
    }
  }

  const DeviceModel device_ = libnifalcon_model();
  const Guard guard_{device_, kPeriod};
  Memory memory_;
  std::int64_t now_ns_ = 1;
  std::uint64_t tick_ = 0, heard_ = 0;
};

TEST_F(Samples, AReplyThatCameWhileTheCommandWasOnItsWayDoesNotMakeItStale) {
  for (std::uint32_t t = 0; t < device_.hold_ticks + 3U; ++t) (void)judge(heard_, false);  // the device answers late
  hear();
  const std::uint64_t late = heard_;
  hear();  // and once more, before the tick's command leaves
  EXPECT_EQ(judge(late, true), GuardVerdict::kNone) << name_of(memory_.verdict);
  for (std::uint32_t t = 0; t < device_.hold_ticks; ++t) EXPECT_EQ(judge(late, true), GuardVerdict::kNone) << t;
  EXPECT_EQ(judge(late, true), GuardVerdict::kStale) << "it has looked at no packet for too long";
}

TEST_F(Samples, ACommandThatKnowsNoNewReplyIsStale) {
  const std::uint64_t old = heard_;
  for (std::uint32_t t = 0; t < device_.hold_ticks; ++t) {
    hear();
    EXPECT_EQ(judge(old, true), GuardVerdict::kNone) << t;
  }
  hear();
  EXPECT_EQ(judge(old, true), GuardVerdict::kStale) << name_of(memory_.verdict);
}

/// Ends what a wrong command has led to: no force for longer than the guard waits, in so many ticks.
class Stopped : public Samples {
 protected:
  void SetUp() override {
    Samples::SetUp();
    hear();
    ASSERT_EQ(judge(heard_, 5000), GuardVerdict::kLimit);
  }
  GuardVerdict quiet_for(std::int64_t ns, std::uint64_t ticks) {
    hear();
    (void)judge(heard_, 0);
    now_ns_ += ns;
    tick_ += ticks - 2;
    hear();
    return judge(heard_, 0);
  }
};

TEST_F(Stopped, TheGuardBelievesATickAgainThatHasBeenQuiet) { EXPECT_EQ(quiet_for(110'000'000, 110), GuardVerdict::kNone); }

TEST_F(Stopped, APauseOfTheTickIsNoQuiet) {
  tick_ -= 1;
  EXPECT_EQ(quiet_for(2'000'000'000, 2), GuardVerdict::kLimit) << "the tick has not heard of it";
}

/// A hand at a ball of 8 mm and 0.8 N/mm.
class AtABall : public ::testing::Test {
 protected:
  /// A hand that is first seen at one distance from the middle, mm, and goes to another; there the commands push it outwards, N.
  GuardVerdict push(double first, double then, double push) {
    const double step = first < then ? 0.05 : -0.05;
    for (int t = 0; t <= std::lround((then - first) / step); ++t) (void)tick_at(first + t * step, 0);
    return tick_at(then, push);
  }
  GuardVerdict verdict() const { return memory_.verdict; }
  void reset() { memory_ = {}, tick_ = 0; }

  GuardVerdict tick_at(double r, double push) {
    const core::Counts counts = bench_.counts_at(test::kCentre + test::Point{r, 0, 0});
    guard_.hear(encode(FalconReply{counts, 0, 7}), now_ns_, memory_);
    now_ns_ += kPeriod;
    loop::Command command;
    command.tick = ++tick_;
    command.sample = tick_;
    command.field_generation = 1;
    command.falcon.flags = bench_.model.device.led_active;
    const test::Angles angles = bench_.set.twin.angles_of(counts);
    const test::Angles torques = bench_.set.twin.torques(*bench_.set.twin.forward(angles), angles, {push, 0, 0});
    for (std::size_t i = 0; i < 3; ++i)
      command.falcon.words[i] = static_cast<std::int16_t>(-torques[i] / bench_.set.twin.newton_mm_per_word);
    Evidence evidence;
    evidence.now_ns = now_ns_;
    evidence.field = &test::ball().view();
    evidence.surface = 1;
    (void)guard_.judge(command, evidence, memory_);
    return memory_.verdict;
  }

 private:
  test::DeviceBench bench_;
  const Guard guard_{bench_.model.device, kPeriod};
  Memory memory_;
  std::int64_t now_ns_ = 1;
  std::uint64_t tick_ = 0;
};

TEST_F(AtABall, AForceThatPushesAHandOutWhichWasFirstSeenInsideIsHonest) {
  const GuardVerdict verdict = push(5, 7.4, 2.8);
  EXPECT_EQ(verdict, GuardVerdict::kNone) << name_of(verdict);
}

TEST_F(AtABall, AForceThatPullsAHandInWhichCameFromOutsideIsStopped) { EXPECT_EQ(push(12, 7, -2.2), GuardVerdict::kPull); }

TEST_F(AtABall, AForceThatRisesOrTremblesAsFastAsTheMotorsFollowIsTooStrong) {
  constexpr double kStep = 1.75;  // N: a thousand motor commands, as many as change in a tick
  for (const bool trembles : {false, true}) {
    reset();
    ASSERT_EQ(push(12, 7.5, 0.3), GuardVerdict::kNone) << name_of(verdict());
    GuardVerdict found = GuardVerdict::kNone;
    for (int t = 1; t <= 5 && found == GuardVerdict::kNone; ++t) found = tick_at(7.5, trembles && t > 2 ? (2 + t % 2) * kStep : t * kStep);
    EXPECT_EQ(found, GuardVerdict::kStrong) << name_of(found);
  }
}

TEST_F(AtABall, AForceThatPushesAHandOutWhichCameFromOutsideIsHonest) { EXPECT_EQ(push(12, 7, 2.2), GuardVerdict::kNone); }

/// A field that the guard cannot look at explains any force; without a field, none is explained.
class Fading : public Samples {
 protected:
  static constexpr std::uint32_t kUnknown = 5, kNoField = 0;
  static constexpr int kForce = 2000;

  void SetUp() override {
    Samples::SetUp();
    for (int i = 0; i < 3; ++i) {
      hear();
      ASSERT_EQ(judge(heard_, kForce + i, kUnknown), GuardVerdict::kNone) << name_of(memory_.verdict);
    }
    hear();
  }
  int slew() const { return static_cast<int>(device_.word_slew / 1000); }
};

TEST_F(Fading, AForceMayFadeAsFastAsTheMotorsFollow) {
  EXPECT_EQ(judge(heard_, kForce + 2 - slew(), kNoField), GuardVerdict::kNone) << name_of(memory_.verdict);
}

TEST_F(Fading, AForceThatFadesMoreSlowlyIsStopped) {
  EXPECT_EQ(judge(heard_, kForce + 2 - slew() / 2, kNoField), GuardVerdict::kFree) << name_of(memory_.verdict);
}

TEST_F(Fading, ATickWhoseCommandWasNeverSentMayHaveRaisedTheForceThatFades) {
  ++tick_;  // it asked for slew() / 4 more
  EXPECT_EQ(judge(heard_, kForce + 2 - slew() * 3 / 4, kNoField), GuardVerdict::kNone) << name_of(memory_.verdict);
  hear();
  EXPECT_EQ(judge(heard_, kForce + 2 - slew() * 3 / 2, kNoField), GuardVerdict::kFree) << "this time no tick was left out";
}

TEST_F(Fading, AForceThatChangesSidesIsNotFading) {
  EXPECT_EQ(judge(heard_, -(kForce - slew()), kNoField), GuardVerdict::kFree) << name_of(memory_.verdict);
}

TEST_F(Fading, BesideATickWhoseCommandWasNeverSentForceMustFadeAllTheSame) {
  ++tick_;
  EXPECT_EQ(judge(heard_, kForce + 2, kNoField), GuardVerdict::kFree) << name_of(memory_.verdict);
}

}  // namespace
}  // namespace isotouch::guard
