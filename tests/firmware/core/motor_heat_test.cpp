#include "firmware/core/motor_heat.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

namespace isotouch::core {
namespace {

constexpr std::uint32_t kPeriod = 1'000'000;

struct Bench {
  explicit Bench(DeviceModel model = libnifalcon_model(), std::uint32_t period_ns = kPeriod)
      : device(model), motors(make_motors(device, period_ns)), budget(make_heat_budget(device, period_ns)) {}

  /// Asks for a command in all motors for so many ticks, gets what the limit leaves; the last one.
  std::int16_t ask(int word, int ticks) {
    std::int16_t got = 0;
    for (int t = 0; t < ticks; ++t) {
      const CommandLimit limit = command_limit(motors, budget, heat);
      got = static_cast<std::int16_t>(std::min(word, limit.motors.limit >> 8));
      warm({got, static_cast<std::int16_t>(-got / 2), 0}, budget, heat);
      hottest = std::max(hottest, square(0));
    }
    return got;
  }
  double square(std::size_t motor) const { return double(heat.squares[motor]) / 65536; }
  bool lowered() const { return command_limit(motors, budget, heat).lowered; }

  DeviceModel device;
  Motors motors;
  HeatBudget budget;
  MotorHeat heat;
  double hottest = 0;
};

TEST(MotorHeat, FollowsTheMeanSquareInTheMotorsTime) {
  Bench bench;
  bench.ask(0, 100'000);
  EXPECT_LT(bench.square(0), 0.01 * 2000 * 2000);
  bench.ask(1500, 20'000);  // one time constant
  EXPECT_NEAR(bench.square(0), 1500.0 * 1500 * (1 - std::exp(-1)), 1500.0 * 1500 * 0.01);
  EXPECT_NEAR(bench.square(1), 750.0 * 750 * (1 - std::exp(-1)), 750.0 * 750 * 0.02);
  EXPECT_LT(bench.heat.squares[2], bench.heat.squares[1] / 10);
}

TEST(MotorHeat, WhatTheMotorStandsForEverIsNeverLimited) {
  Bench bench;
  bench.ask(0, 1);
  for (int minute = 0; minute < 5; ++minute) EXPECT_EQ(bench.ask(2000, 60'000), 2000);
  EXPECT_LE(bench.hottest, 2000.0 * 2000);
}

TEST(MotorHeat, MoreThanThatFallsToItAndTheBudgetIsKept) {
  Bench bench;
  bench.ask(0, 100'000);
  EXPECT_EQ(bench.ask(4095, 1000), 4095) << "for a second a cool motor gives all";
  EXPECT_FALSE(bench.lowered());
  EXPECT_NEAR(bench.ask(4095, 100'000), 2000, 15);
  EXPECT_TRUE(bench.lowered());
  EXPECT_LE(bench.hottest, 2000.0 * 2000 * 1.001);
  EXPECT_EQ(bench.ask(0, 100'000), 0);
  EXPECT_FALSE(bench.lowered());
}

TEST(MotorHeat, TheLimitBeginsAtThreeQuartersOfTheBudget) {
  Bench bench;
  bench.heat.has_begun = true;
  bench.heat.squares[2] = std::int64_t{3'000'000} << 16;
  EXPECT_FALSE(bench.lowered());
  EXPECT_EQ(command_limit(bench.motors, bench.budget, bench.heat).motors.limit, 4095 << 8);
  bench.heat.squares[2] = std::int64_t{3'001'000} << 16;
  EXPECT_TRUE(bench.lowered());
  bench.heat.squares[2] = std::int64_t{3'500'000} << 16;
  EXPECT_NEAR(command_limit(bench.motors, bench.budget, bench.heat).motors.limit / 256.0, (4095 + 2000) / 2.0, 1);
  bench.heat.squares[2] = std::int64_t{16'777'216} << 16;
  EXPECT_NEAR(command_limit(bench.motors, bench.budget, bench.heat).motors.limit / 256.0, 2000, 1);
}

TEST(MotorHeat, WhatIsNotKnownIsTakenForThreeQuarters) {
  Bench bench;
  bench.ask(0, 1);
  EXPECT_NEAR(bench.square(0), 3'000'000, 200);
  EXPECT_LT(bench.ask(4095, 3000), 4000);
}

TEST(MotorHeat, WhatIsHandedOnIsThatOfTheWarmestRoundedUp) {
  MotorHeat heat;
  EXPECT_EQ(heat_input(heat), 0U) << "not known";
  EXPECT_FALSE(heat_from(0).has_begun);
  heat.has_begun = true;
  EXPECT_EQ(heat_input(heat), 1U) << "known, and cold";
  for (const std::int64_t most : {std::int64_t{1}, std::int64_t{255}, std::int64_t{256}, std::int64_t{257}, std::int64_t{4'000'000} << 16,
                                  std::int64_t{4095 * 4095} << 16}) {
    heat.squares = {most / 2, most, 0};
    const MotorHeat after = heat_from(heat_input(heat));
    for (const std::int64_t square : after.squares) {
      EXPECT_GE(square, most);
      EXPECT_LT(square, most + 256);
    }
    EXPECT_TRUE(after.has_begun);
    EXPECT_EQ(heat_input(after), heat_input(heat)) << "it does not grow by being handed on";
  }
  heat.squares[2] = std::numeric_limits<std::int64_t>::max();  // nobody watches
  EXPECT_EQ(heat_input(heat), std::numeric_limits<std::uint32_t>::max());
}

TEST(MotorHeat, IsTheSameAtEveryRateAndAtTheBordersOfItsSettings) {
  for (const std::uint32_t period : {100'000U, 4'000'000U}) {
    for (const std::int32_t word : {1, 2000, 4095}) {
      for (const std::uint32_t ms : {1'000U, 1'000'000U}) {
        DeviceModel model = libnifalcon_model();
        model.heat_word = word;
        model.heat_ms = ms;
        Bench bench(model, period);
        bench.ask(0, 1);
        const int ticks = static_cast<int>(std::min(5.0 * ms * 1e6 / period, 300'000.0));
        const std::int16_t got = bench.ask(4095, ticks);
        EXPECT_GE(got, word) << period << " " << word << " " << ms;
        if (ticks < 300'000) {
          EXPECT_NEAR(got, word, 0.03 * word + 2) << period << " " << word << " " << ms;
        }
        EXPECT_LE(bench.hottest, double{1.0 * word} * word * 1.05 + 4095.0 * 4095 * period / 1e6 / ms)
            << period << " " << word << " " << ms;
      }
    }
  }
}

}  // namespace
}  // namespace isotouch::core
