#include "firmware/core/hand_damping.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/support/random.h"

namespace isotouch::core {
namespace {

constexpr PerSecond kRate = PerSecond::of(1000);

Vec3<Mm> mm(const test::Point& p) {
  const auto q = [](double v) { return Mm::from_raw(static_cast<std::int32_t>(std::lround(v * 1048576))); };
  return {q(p.x), q(p.y), q(p.z)};
}
double mm_s(MmPerS v) { return v.raw() / 4096.0; }

TEST(HandDamping, AHandWhoseCountsFlickerHasNoSpeed) {
  QuietVelocityState state;
  test::Random random(71);
  for (int t = 0; t < 200; ++t) quiet_velocity(mm({0, 0, 0.02 * std::min(t, 100)}), true, kRate, state);
  double fastest = 0;
  for (int t = 0; t < 10'000; ++t) {
    const Vec3<MmPerS> v =
        quiet_velocity(mm({(random.bits() % 2 == 0 ? 0.046 : 0.0), 0, 2 - (random.bits() % 2 == 0 ? 0.046 : 0.0)}), true, kRate, state);
    if (t > 100) fastest = std::max({fastest, std::abs(mm_s(v.x)), std::abs(mm_s(v.z))});
  }
  EXPECT_LT(fastest, 0.001);
}

TEST(HandDamping, AMovingHandHasItsOwnSpeed) {
  for (const double speed : {-300.0, -20.0, 5.0, 80.0}) {
    QuietVelocityState state;
    Vec3<MmPerS> v;
    for (int t = 0; t < 200; ++t) v = quiet_velocity(mm({speed * 0.001 * t, 1, 2}), true, kRate, state);
    EXPECT_NEAR(mm_s(v.x), speed, 0.01) << speed;
    EXPECT_EQ(v.y, MmPerS{});
  }
}

TEST(HandDamping, TheForceIsAgainstTheSpeed) {
  const Vec3<Newton> force = damping_force({MmPerS::of(100), MmPerS::of(-50), MmPerS{}}, Damping::of(0.004));
  EXPECT_NEAR(force.x.raw() / 65536.0, -0.4, 0.00002);
  EXPECT_NEAR(force.y.raw() / 65536.0, 0.2, 0.00002);
  EXPECT_EQ(force.z, Newton{});
}

}  // namespace
}  // namespace isotouch::core
