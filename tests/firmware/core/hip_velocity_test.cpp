#include "firmware/core/hip_velocity.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/random.h"

namespace isotouch::core {
namespace {

Vec3<Mm> at(double x, double y, double z) {
  const auto q = [](double v) { return Mm::from_raw(static_cast<std::int32_t>(std::lround(v * 1048576))); };
  return {q(x), q(y), q(z)};
}
double real(MmPerS v) { return v.raw() / 4096.0; }

TEST(HipVelocity, OfEvenMotionIsItsSpeedAtEveryRate) {
  for (const double hertz : {250.0, 1000.0, 10000.0}) {
    const PerSecond rate = PerSecond::from_raw(static_cast<std::int32_t>(hertz * 256));
    VelocityState state;
    Vec3<MmPerS> v;
    for (int t = 0; t < 200; ++t) v = hip_velocity(at(100 * t / hertz, -30 * t / hertz, 5), true, rate, state);
    EXPECT_NEAR(real(v.x), 100, 0.02);
    EXPECT_NEAR(real(v.y), -30, 0.02);
    EXPECT_EQ(v.z, MmPerS{});
  }
}

TEST(HipVelocity, RepeatedSamplesDoNotLookLikeRest) {
  test::Random random(111);
  VelocityState state;
  Vec3<MmPerS> v;
  double x = 0;
  for (int t = 0; t < 5000; ++t) {
    x += 0.2;
    const bool fresh = random.bits() % 4 != 0;
    v = hip_velocity(fresh ? at(x, 0, 0) : at(0, 0, 0), fresh, PerSecond::of(1000), state);
    if (t > 100) {
      EXPECT_NEAR(real(v.x), 200, 0.1) << t;
    }
  }
}

TEST(HipVelocity, TheFirstSampleHasNone) {
  VelocityState state;
  EXPECT_EQ(hip_velocity(at(50, 50, 50), true, PerSecond::of(1000), state), Vec3<MmPerS>{});
}

TEST(HipVelocity, AStepComesThroughToNineTenthsInEightSamples) {
  VelocityState state;
  for (int t = 0; t < 10; ++t) hip_velocity(at(0, 0, 0), true, PerSecond::of(1000), state);
  Vec3<MmPerS> v;
  for (int t = 1; t <= 8; ++t) v = hip_velocity(at(0.1 * t, 0, 0), true, PerSecond::of(1000), state);
  EXPECT_NEAR(real(v.x), 90, 0.2);
}

TEST(HipVelocity, SaturatesInsteadOfWrapping) {
  VelocityState state;
  Vec3<MmPerS> v;
  for (int t = 0; t < 40; ++t) v = hip_velocity(at(t % 2 == 0 ? 512 : -512, 0, 0), true, PerSecond::of(10000), state);
  EXPECT_LE(std::abs(real(v.x)), 524288);
  VelocityState up;
  for (int t = 0; t < 3; ++t) v = hip_velocity(at(-512 + 500 * t, 0, 0), true, PerSecond::of(10000), up);
  EXPECT_GT(real(v.x), 100000);
}

}  // namespace
}  // namespace isotouch::core
