#include "firmware/loop/measured_delay.h"

#include <gtest/gtest.h>

namespace isotouch::loop {
namespace {

struct Measured {
  TickStats stats;
  MeasuredDelay delay;

  /// After so many measurements more.
  std::uint32_t ticks(std::int64_t trip_ns, std::int64_t word_ns, std::uint64_t count = MeasuredDelay::kFew) {
    for (std::uint64_t i = 0; i < count; ++i) {
      stats.round_trip.add(trip_ns);
      stats.word_delay.add(word_ns);
      if (i % 100 == 99 || i + 1 == count) delay.look(stats, 1'000'000);
    }
    return delay.ticks();
  }
};

std::uint32_t delay_of(std::int64_t trip_ns, std::int64_t word_ns, std::uint64_t count = MeasuredDelay::kFew) {
  return Measured{}.ticks(trip_ns, word_ns, count);
}

TEST(MeasuredDelay, IsInWholeTicksWithAQuarterForGrace) {
  EXPECT_EQ(delay_of(900'000, 50'000), 1U);
  EXPECT_EQ(delay_of(1'000'000, 200'000), 1U);
  EXPECT_EQ(delay_of(1'200'000, 80'000), 2U);
  EXPECT_EQ(delay_of(2'900'000, 60'000), 3U);
  EXPECT_EQ(delay_of(100'000, 20'000), 0U);
}

TEST(MeasuredDelay, FewMeasurementsSayNothingAndRareOnesLittle) {
  EXPECT_EQ(delay_of(5'000'000, 50'000, MeasuredDelay::kFew - 1), 0U);
  Measured measured;
  measured.ticks(50'000'000, 50'000, 400);
  EXPECT_EQ(measured.ticks(900'000, 50'000, 600), 1U);
}

TEST(MeasuredDelay, OneThatGrowsAfterHoursIsSeenWithinTwoWindows) {
  Measured measured;
  EXPECT_EQ(measured.ticks(900'000, 50'000, 1'000'000), 1U);
  EXPECT_EQ(measured.ticks(2'900'000, 50'000, MeasuredDelay::kWindow / 4), 1U) << "busy for a moment";
  EXPECT_EQ(measured.ticks(900'000, 50'000, 10 * MeasuredDelay::kWindow), 1U);
  EXPECT_EQ(measured.ticks(2'900'000, 50'000, 2 * MeasuredDelay::kWindow), 3U);
}

TEST(MeasuredDelay, AnotherDeviceIsMeasuredByItself) {
  Measured measured;
  measured.ticks(900'000, 50'000, 5 * MeasuredDelay::kWindow / 2);
  measured.delay.begin_anew(measured.stats);
  EXPECT_EQ(measured.ticks(2'900'000, 50'000, MeasuredDelay::kFew - 1), 1U) << "until something is found of it";
  EXPECT_EQ(measured.ticks(2'900'000, 50'000, 1), 3U);
}

}  // namespace
}  // namespace isotouch::loop
