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
  void hear() { hear(0); }
  /// One of a hand that has moved along the device's axis.
  void hear(int count, std::uint8_t homed = 7) {
    const auto all = static_cast<std::int16_t>(count), trembling = static_cast<std::int16_t>(all + (++heard_ % 2 == 0 ? 0 : 1));
    guard_.hear(encode(FalconReply{{all, all, trembling}, 0, homed}), now_ns_, memory_);
  }
  /// The next tick's command, computed from a sample.
  GuardVerdict judge(std::uint64_t sample, bool has_words) { return judge(sample, static_cast<int>(has_words ? 1 + tick_ % 2 : 0)); }
  GuardVerdict judge(std::uint64_t sample, int word, std::uint32_t field_generation = 0) {
    now_ns_ += kPeriod;
    loop::Command command;
    command.tick = ++tick_;
    command.sample = sample;
    command.field_generation = field_generation;
    command.falcon.words.fill(static_cast<std::int16_t>(word));
    command.falcon.flags = light_;
    Evidence evidence;
    evidence.now_ns = now_ns_;
    evidence.lines = lines_;
    passed_ = guard_.judge(command, evidence, memory_);
    return memory_.verdict;
  }
  void SetUp() override {
    for (int i = 0; i < 100; ++i) {
      hear();
      ASSERT_EQ(judge(heard_, i > 2), GuardVerdict::kNone) << name_of(memory_.verdict);
    }
  }

  static constexpr std::uint32_t kUnknown = 5, kNoField = 0;  ///< a field that the guard cannot look at explains any force

  const DeviceModel device_ = libnifalcon_model();
  const Guard guard_{device_, kPeriod};
  Memory memory_;
  MotorCommands passed_{};  ///< of the newest command
  std::uint8_t light_ = device_.led_active, lines_ = 0;
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

TEST_F(Samples, BesideABadLineNothingPassesWhileTheTickMayNotHaveSeenItYet) {
  hear();
  ASSERT_EQ(judge(heard_, true), GuardVerdict::kNone);
  EXPECT_NE(passed_, MotorCommands{});
  lines_ = kLineStop;
  hear();
  EXPECT_EQ(judge(heard_, true), GuardVerdict::kNone) << name_of(memory_.verdict);
  EXPECT_EQ(passed_, MotorCommands{});
}

TEST_F(Samples, ForceUnderTheLightOfNoForceIsStopped) {
  light_ = device_.led_idle;
  hear();
  EXPECT_EQ(judge(heard_, true), GuardVerdict::kLight) << name_of(memory_.verdict);
}

TEST_F(Samples, ForceWhereTheArmsReachNoPlaceIsStopped) {
  for (int count = 0; memory_.has_grip; count += 5) {
    ASSERT_LT(count, 4000);
    hear(count);
    ASSERT_EQ(judge(heard_, false), GuardVerdict::kNone) << name_of(memory_.verdict);
  }
  EXPECT_EQ(judge(heard_, true), GuardVerdict::kPose) << name_of(memory_.verdict);
}

TEST_F(Samples, AReferenceEndsWhereCountsLeapInAPacketWithoutIt) {
  const int most = 2 * device_.count_jump / 8;  // in a packet that comes a tick after the one before
  hear(most - 1, 3);
  EXPECT_EQ(judge(heard_, true), GuardVerdict::kNone) << "a bit that was wrong once: " << name_of(memory_.verdict);
  hear(2 * most + 2, 3);
  EXPECT_EQ(judge(heard_, true), GuardVerdict::kReference) << name_of(memory_.verdict);
}

TEST_F(Samples, ASecondPacketConfirmsAReference) {
  for (const int homed : {2, 1}) {
    hear(300, 0);
    for (int n = 0; n < homed; ++n) {
      ASSERT_EQ(judge(heard_, false), GuardVerdict::kNone);
      hear();
    }
    EXPECT_EQ(judge(heard_, true), homed == 2 ? GuardVerdict::kNone : GuardVerdict::kReference) << name_of(memory_.verdict);
  }
}

TEST_F(Samples, MotorsBearAFifthMoreHeatThanTheTickKeepsTo) {
  for (const double part : {1.05, 1.15}) {
    GuardVerdict found = GuardVerdict::kNone;
    for (int t = 0; t < 200 && found == GuardVerdict::kNone; ++t) {
      now_ns_ += 1'000'000'000;
      hear();
      found = judge(heard_, static_cast<int>(part * device_.heat_word) + t % 2, kUnknown);
    }
    EXPECT_EQ(found, part < 1.1 ? GuardVerdict::kNone : GuardVerdict::kHeat) << name_of(found);
  }
}

TEST_F(Samples, AHandThatMovesMeetsTheSameCommandsForFiveTicksAtMost) {
  for (int t = 0; t <= 5; ++t) {
    hear(20 * t);
    EXPECT_EQ(judge(heard_, 2000, kUnknown), t < 5 ? GuardVerdict::kNone : GuardVerdict::kRepeat) << t << ": " << name_of(memory_.verdict);
  }
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

TEST_F(Stopped, TheGuardBelievesATickAgainThatHasBeenQuiet) {
  EXPECT_EQ(quiet_for(90'000'000, 90), GuardVerdict::kLimit);
  EXPECT_EQ(quiet_for(10'000'000, 10), GuardVerdict::kNone);
}

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
  /// The same surface, from now on by another generation.
  void move_surface() { ++generation_; }

  GuardVerdict tick_at(double r, double push) {
    const Guard guard(device_, kPeriod);
    const core::Counts counts = bench_.counts_at(test::kCentre + test::Point{r, 0, 0});
    guard.hear(encode(FalconReply{counts, 0, 7}), now_ns_, memory_);
    now_ns_ += kPeriod;
    loop::Command command;
    command.tick = ++tick_;
    command.sample = tick_;
    command.field_generation = generation_;
    command.falcon.flags = device_.led_active;
    const test::Angles angles = bench_.set.twin.angles_of(counts);
    const test::Angles torques = bench_.set.twin.torques(*bench_.set.twin.forward(angles), angles, {push, 0, 0});
    for (std::size_t i = 0; i < 3; ++i)
      command.falcon.words[i] = static_cast<std::int16_t>(-torques[i] / bench_.set.twin.newton_mm_per_word);
    Evidence evidence;
    evidence.now_ns = now_ns_;
    evidence.field = &field_;
    evidence.surface = 1;
    evidence.largest = largest_;
    (void)guard.judge(command, evidence, memory_);
    return memory_.verdict;
  }

  test::DeviceBench bench_;
  DeviceModel device_ = bench_.model.device;
  FieldView field_ = test::ball().view();
  TickSettings largest_;

 private:
  Memory memory_;
  std::int64_t now_ns_ = 1;
  std::uint64_t tick_ = 0;
  std::uint32_t generation_ = 1;
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

TEST_F(AtABall, HoweverFarAHandHasComeTheForceEndsAtItsLimit) {
  EXPECT_EQ(push(12, 2, 4), GuardVerdict::kNone) << name_of(verdict());
  reset();
  largest_.force_limit = Newton::of(2);
  EXPECT_EQ(push(12, 2, 4), GuardVerdict::kStrong) << name_of(verdict());
}

TEST_F(AtABall, NoForceIsThatOfAHandDeeperThanItMayBe) {
  device_.penetration_limit = Mm::of(1);
  EXPECT_EQ(push(12, 2, 4), GuardVerdict::kStrong) << name_of(verdict());
}

TEST_F(AtABall, ASurfaceThatMovesAddsFourVoxelsAsGentlyAsTheForceMayFollow) {
  for (const int ticks : {2, 40}) {
    for (const double force : {2.8, 4.5}) {
      reset();
      ASSERT_EQ(push(12, 7.5, 0.3), GuardVerdict::kNone) << name_of(verdict());
      move_surface();
      for (int t = 1; t < ticks; ++t) ASSERT_EQ(tick_at(7.5, 0), GuardVerdict::kNone) << name_of(verdict());
      EXPECT_EQ(tick_at(7.5, force), ticks == 40 && force < 4 ? GuardVerdict::kNone : GuardVerdict::kStrong) << ticks << ' ' << force;
    }
  }
}

TEST_F(AtABall, TheLevelsOfAPublishedFieldAreNoDistances) {
  EXPECT_EQ(push(12, 11, 1), GuardVerdict::kFree) << name_of(verdict());
  reset();
  field_.method = Method::kPublished;
  EXPECT_EQ(push(12, 11, 1), GuardVerdict::kNone) << name_of(verdict());
}

/// Without a field no force is explained.
class Fading : public Samples {
 protected:
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
