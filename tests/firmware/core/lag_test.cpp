#include "firmware/core/lag.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/support/random.h"

namespace isotouch::core {
namespace {

using test::Point;

Point newton(const Vec3<Newton>& f) { return {f.x.raw() / 65536.0, f.y.raw() / 65536.0, f.z.raw() / 65536.0}; }
Vec3<Newton> fixed(const Point& p) {
  const auto part = [](double v) { return Newton::from_raw(static_cast<std::int32_t>(std::lround(v * 65536))); };
  return {part(p.x), part(p.y), part(p.z)};
}
constexpr double kRounding = 3e-4;

LagInput input(const Point& target, const Point& step, const Point& by_hand, const Lag& lag) {
  return {fixed(target), fixed(step), fixed(by_hand), {}, {}, {}, lag.felt, true, true, false};
}
LagInput no_contact(bool arriving) { return {{}, {}, {}, {}, {}, {}, {}, false, false, arriving}; }

TEST(Lag, WhateverTheTargetDoesTheForceFollowsItByLittle) {
  test::Random random(1);
  for (int trial = 0; trial < 2000; ++trial) {
    Lag lag;
    surface_moved(fixed(random.in_ball(10)), lag);
    Point target = random.in_ball(trial % 10 == 0 ? 9000 : 20);
    bool touching = random.bits() % 4 != 0;
    Point aim;
    for (int tick = 0; tick < 30; ++tick) {
      const bool rests = random.bits() % 2 == 0;
      const Point by_hand = rests ? Point{} : random.in_ball(0.5);
      if (tick < 10 || rests) {
        if (random.bits() % 3 == 0) target = random.in_ball(20), touching = random.bits() % 4 != 0, surface_moved({}, lag);
      }
      const Point last = aim;
      const Point before = newton(lag.felt), wanted = touching ? target : Point{};
      aim = wanted;
      LagInput in = input(wanted, wanted - last, by_hand, lag);
      in.touching = touching;
      const Point felt = newton(follow_target(in, lag));
      ASSERT_LE(length(felt - before), 0.05 + length(by_hand) + kRounding);
      ASSERT_LE(length(felt), std::max(length(wanted), length(before)) + kRounding);
      if (dot(before, wanted) < 0 || !touching) continue;
      ASSERT_GE(dot(felt, wanted), -kRounding * length(wanted)) << "it begins to pull";
    }
  }
}

TEST(Lag, EndsWhenTheForceHasFollowed) {
  Lag lag;
  surface_moved(fixed({0, 0, 1}), lag);
  const LagInput in = input({0, 0, 3}, {}, {}, lag);
  int ticks = 0;
  for (; lag.on && ticks < 1000; ++ticks) follow_target(in, lag);
  EXPECT_NEAR(ticks, 2 / 0.0475, 1.5);
  EXPECT_EQ(lag.felt, in.target);
}

TEST(Lag, LastsWhileTheProxyArrives) {
  Lag lag;
  surface_moved({}, lag);
  for (int tick = 0; tick < 100; ++tick) follow_target(no_contact(true), lag);
  EXPECT_TRUE(lag.on);
  for (std::uint32_t tick = 0; tick < kSettlingTicks; ++tick) follow_target(no_contact(false), lag);
  EXPECT_FALSE(lag.on);
}

TEST(Lag, TheHandsOwnWayIsFeltAtOnce) {
  Lag lag;
  surface_moved(fixed({0, 0, 2}), lag);
  for (std::uint32_t tick = 0; tick <= kSettlingTicks; ++tick) follow_target(input({0, 0, 8}, {}, {}, lag), lag);
  const double before = newton(lag.felt).z;
  const Point felt = newton(follow_target(input({0, 0, 7.5}, {0, 0, -0.5}, {0, 0, 0.5}, lag), lag));
  EXPECT_NEAR(felt.z, before - 0.5 + 0.0475, kRounding);
}

}  // namespace
}  // namespace isotouch::core
