#include "firmware/core/motion.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/support/random.h"

namespace isotouch::core {
namespace {

Vec3<Mm> at(double x, double y = 0, double z = 0) {
  const auto q = [](double v) { return Mm::from_raw(static_cast<std::int32_t>(std::lround(v * 1048576))); };
  return {q(x), q(y), q(z)};
}
double mm_s(MmPerS v) { return v.raw() / 4096.0; }

std::uint32_t period_of(double hertz) { return static_cast<std::uint32_t>(std::lround(1e9 / hertz)); }
MotionModel model_at(double hertz) { return make_motion_model(libnifalcon_model(), period_of(hertz)); }
const MotionModel kModel = model_at(1000);

TEST(Velocity, OfEvenMotionIsItsSpeedAtEveryRate) {
  for (const double hertz : {250.0, 1000.0, 10000.0}) {
    MotionState state;
    Motion motion;
    for (int t = 0; t < 200; ++t) motion = track_motion(at(100 * t / hertz, -30 * t / hertz, 5), true, false, model_at(hertz), state);
    EXPECT_NEAR(mm_s(motion.velocity.x), 100, 0.02);
    EXPECT_NEAR(mm_s(motion.velocity.y), -30, 0.02);
    EXPECT_EQ(motion.velocity.z, MmPerS{});
  }
}

TEST(Velocity, RepeatedSamplesDoNotLookLikeRest) {
  test::Random random(111);
  MotionState state;
  double x = 0;
  for (int t = 0; t < 5000; ++t) {
    x += 0.2;
    const bool fresh = random.bits() % 4 != 0;
    const Motion motion = track_motion(fresh ? at(x) : at(0), fresh, false, kModel, state);
    if (t > 100) {
      EXPECT_NEAR(mm_s(motion.velocity.x), 200, 0.1) << t;
    }
  }
}

TEST(Velocity, TheFirstSampleHasNone) {
  MotionState state;
  EXPECT_EQ(track_motion(at(50, 50, 50), true, true, kModel, state).velocity, Vec3<MmPerS>{});
}

TEST(Velocity, AStepComesThroughToNineTenthsInEightSamples) {
  MotionState state;
  for (int t = 0; t < 10; ++t) track_motion(at(0), true, false, kModel, state);
  Motion motion;
  for (int t = 1; t <= 8; ++t) motion = track_motion(at(0.1 * t), true, false, kModel, state);
  EXPECT_NEAR(mm_s(motion.velocity.x), 90, 0.2);
}

TEST(Velocity, SaturatesInsteadOfWrapping) {
  const MotionModel model = model_at(10000);
  MotionState state;
  Motion motion;
  for (int t = 0; t < 40; ++t) motion = track_motion(at(t % 2 == 0 ? 512 : -512), true, true, model, state);
  EXPECT_LE(std::abs(mm_s(motion.velocity.x)), 524288);
  EXPECT_LE(std::abs(mm_s(motion.quiet.x)), 524288);
  MotionState up;
  for (int t = 0; t < 3; ++t) motion = track_motion(at(-512 + 500 * t), true, true, model, up);
  EXPECT_GT(mm_s(motion.velocity.x), 100000);
  EXPECT_GT(mm_s(motion.quiet.x), 100000);
}

TEST(QuietVelocity, AHandWhoseCountsFlickerHasNone) {
  MotionState state;
  test::Random random(71);
  for (int t = 0; t < 200; ++t) track_motion(at(0, 0, 0.02 * std::min(t, 100)), true, true, kModel, state);
  double fastest = 0;
  for (int t = 0; t < 10'000; ++t) {
    const Vec3<Mm> hip = at((random.bits() % 2 == 0 ? 0.046 : 0.0), 0, 2 - (random.bits() % 2 == 0 ? 0.046 : 0.0));
    const Motion motion = track_motion(hip, true, true, kModel, state);
    if (t > 100) fastest = std::max({fastest, std::abs(mm_s(motion.quiet.x)), std::abs(mm_s(motion.quiet.z))});
  }
  EXPECT_LT(fastest, 0.001);
}

TEST(QuietVelocity, ThePlayIsThatOfTheDevice) {
  DeviceModel device = libnifalcon_model();
  const auto fastest_in_flicker = [&](Mm play) {
    device.play = play;
    const MotionModel model = make_motion_model(device, 1'000'000);
    MotionState state;
    double fastest = 0;
    for (int t = 0; t < 400; ++t) {
      const Motion motion = track_motion(at(t % 2 == 0 ? 0.0 : 0.08), true, true, model, state);
      if (t > 100) fastest = std::max(fastest, std::abs(mm_s(motion.quiet.x)));
    }
    return fastest;
  };
  EXPECT_GT(fastest_in_flicker(Mm::of(0.03)), 1.0);
  EXPECT_LT(fastest_in_flicker(Mm::of(0.09)), 0.001);
}

TEST(QuietVelocity, OfAMovingHandIsItsSpeed) {
  for (const double speed : {-300.0, -20.0, 5.0, 80.0}) {
    MotionState state;
    Motion motion;
    for (int t = 0; t < 200; ++t) motion = track_motion(at(speed * 0.001 * t, 1, 2), true, true, kModel, state);
    EXPECT_NEAR(mm_s(motion.quiet.x), speed, 0.01) << speed;
    EXPECT_EQ(motion.quiet.y, MmPerS{});
  }
}

TEST(QuietVelocity, IsZeroWhereNothingDampsAndForgetsItsPast) {
  MotionState state;
  for (int t = 0; t < 50; ++t) track_motion(at(0.1 * t), true, true, kModel, state);
  EXPECT_EQ(track_motion(at(5), true, false, kModel, state).quiet, Vec3<MmPerS>{});
  EXPECT_EQ(track_motion(at(5.1), true, true, kModel, state).quiet, Vec3<MmPerS>{}) << "the first sample after it has no velocity";
  track_motion(at(5.2), true, true, kModel, state);
  forget_quiet(state);
  EXPECT_EQ(track_motion(at(5.3), true, true, kModel, state).quiet, Vec3<MmPerS>{});
}

TEST(DampingForce, IsAgainstTheVelocity) {
  const Vec3<Newton> force = damping_force({MmPerS::of(100), MmPerS::of(-50), MmPerS{}}, Damping::of(0.004));
  EXPECT_NEAR(force.x.raw() / 65536.0, -0.4, 0.00002);
  EXPECT_NEAR(force.y.raw() / 65536.0, 0.2, 0.00002);
  EXPECT_EQ(force.z, Newton{});
}

TEST(Leap, TheLargestMoveIsATicksWayAtTwiceTheLimit) {
  EXPECT_EQ(kModel.largest_move, Mm::of(4));
  EXPECT_NEAR(model_at(10'000).largest_move.raw(), Mm::of(0.4).raw(), 1);
  DeviceModel device = libnifalcon_model();
  device.speed_limit = MmPerS::of(100'000);
  EXPECT_EQ(make_motion_model(device, 4'000'000).largest_move, Mm::of(100));
  device.speed_limit = MmPerS::of(1);
  EXPECT_GT(make_motion_model(device, 100'000).largest_move, Mm{});
}

TEST(Leap, IsAMoveBeyondThatAndReportedOnce) {
  MotionState state;
  const auto leapt = [&](double x) { return track_motion(at(x), true, false, kModel, state).leapt; };
  EXPECT_FALSE(leapt(50)) << "the first one has no place before it";
  EXPECT_FALSE(leapt(54));
  EXPECT_TRUE(leapt(49.99));
  EXPECT_FALSE(leapt(49.99));
}

TEST(Leap, MissedSamplesAllowTheirWayUpToEight) {
  for (const int missed : {1, 6, 7, 30}) {
    const double most = 4.0 * std::min(missed + 1, 8);
    for (const double way : {most, most + 0.01}) {
      MotionState state;
      track_motion(at(0), true, false, kModel, state);
      for (int t = 0; t < missed; ++t) EXPECT_FALSE(track_motion(at(700), false, false, kModel, state).leapt);
      EXPECT_EQ(track_motion(at(way), true, false, kModel, state).leapt, way > most) << missed;
    }
  }
}

TEST(Way, IsFromTickToTickWhetherFreshOrNot) {
  MotionState state;
  track_motion(at(1), true, false, kModel, state);
  EXPECT_EQ(track_motion(at(3), false, false, kModel, state).way, at(2));
  EXPECT_EQ(track_motion(at(3), true, false, kModel, state).way, Vec3<Mm>{});
}

}  // namespace
}  // namespace isotouch::core
