#include "shared/tick_times.h"

#include <gtest/gtest.h>

#include <cmath>

namespace isotouch {
namespace {

TEST(TickTimes, ATimeIsTheFewestTicksThatLastAsLong) {
  EXPECT_EQ(ticks_of_ms(3, 1'000'000), 3U);
  EXPECT_EQ(ticks_of_ms(3.001, 1'000'000), 4U);
  EXPECT_EQ(ticks_of_ms(3, 4'000'000), 1U);
  EXPECT_EQ(ticks_of_ms(0, 1'000'000), 1U);
  EXPECT_EQ(ticks_of_ms(0, 1'000'000, 0), 0U);
  EXPECT_EQ(hold_ticks(3, 4'000'000), 2U);
}

TEST(TickTimes, APeriodThatWasRoundedToNanosecondsTakesNoTickMore) {
  for (int hz = 250; hz <= 10'000; ++hz) {
    const auto period_ns = static_cast<std::uint32_t>(std::llround(1e9 / hz));
    for (const int ms : {1, 3, 50, 200, 1000})
      ASSERT_EQ(ticks_of_ms(ms, period_ns), static_cast<unsigned>((ms * hz + 999) / 1000)) << hz << " Hz, " << ms << " ms";
  }
}

TEST(TickTimes, APublishedModelHasTheSameTimesAtEveryPeriod) {
  const DeviceModel model = libnifalcon_model();
  EXPECT_EQ(at_period(model, 1'000'000), model);
  DeviceModel fast = model;
  fast.hold_ticks = 12;
  fast.ramp_ticks = 800;
  EXPECT_EQ(at_period(model, 250'000), fast);
  DeviceModel slow = model;
  slow.hold_ticks = 2;
  slow.ramp_ticks = 50;
  EXPECT_EQ(at_period(model, 4'000'000), slow);
}

}  // namespace
}  // namespace isotouch
