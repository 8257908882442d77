#include "firmware/loop/measured_delay.h"

#include <gtest/gtest.h>

namespace isotouch::loop {
namespace {

std::uint32_t delay_of(std::int64_t trip_ns, std::int64_t word_ns, int count = 1000) {
  TickStats stats;
  for (int i = 0; i < count; ++i) {
    stats.round_trip.add(trip_ns);
    stats.word_delay.add(word_ns);
  }
  return measured_delay_ticks(stats, 1'000'000);
}

TEST(MeasuredDelay, IsInWholeTicksWithAQuarterForGrace) {
  EXPECT_EQ(delay_of(900'000, 50'000), 1U);
  EXPECT_EQ(delay_of(1'000'000, 200'000), 1U);
  EXPECT_EQ(delay_of(1'200'000, 80'000), 2U);
  EXPECT_EQ(delay_of(2'900'000, 60'000), 3U);
  EXPECT_EQ(delay_of(100'000, 20'000), 0U);
}

TEST(MeasuredDelay, FewMeasurementsSayNothingAndRareOnesLittle) {
  EXPECT_EQ(delay_of(5'000'000, 50'000, 999), 0U);
  TickStats stats;
  for (int i = 0; i < 1000; ++i) {
    stats.round_trip.add(i < 400 ? 50'000'000 : 900'000);
    stats.word_delay.add(50'000);
  }
  EXPECT_EQ(measured_delay_ticks(stats, 1'000'000), 1U);
}

}  // namespace
}  // namespace isotouch::loop
