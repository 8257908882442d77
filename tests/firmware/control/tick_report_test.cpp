#include "firmware/control/tick_report.h"

#include <gtest/gtest.h>

#include <array>
#include <vector>

namespace isotouch::control {
namespace {

using protocol::Measure;

/// Each measure has a number of its own, one tick more than the one before it.
struct Counted {
  Counted() {
    const std::array<loop::Histogram*, protocol::kMeasures> all = {&stats.wake_delay, &stats.tick_time, &stats.round_trip,
                                                                   &stats.word_delay};
    for (std::size_t i = 0; i < all.size(); ++i) {
      for (std::size_t n = 0; n <= i; ++n) all[i]->add(kNs[i]);
    }
  }
  static constexpr std::array<std::uint32_t, 4> kNs = {11, 220, 33'000, 4'400'000};
  loop::TickStats stats;
};

TEST(TickReport, EveryMeasureIsItsOwn) {
  EXPECT_EQ(static_cast<int>(Measure::kWakeup), 0);
  EXPECT_EQ(static_cast<int>(Measure::kTick), 1);
  EXPECT_EQ(static_cast<int>(Measure::kRoundTrip), 2);
  EXPECT_EQ(static_cast<int>(Measure::kDelay), 3);
  const Counted counted;
  const protocol::StatusReport report = status_report({}, counted.stats, {});
  std::vector<std::uint8_t> scratch(kHistogramScratch);
  for (std::size_t i = 0; i < protocol::kMeasures; ++i) {
    EXPECT_EQ(report.measures[i].max, Counted::kNs[i]) << i;
    const protocol::HistogramReport histogram = histogram_report(static_cast<Measure>(i), counted.stats, scratch);
    EXPECT_EQ(histogram.measure, i);
    EXPECT_EQ(histogram.count, i + 1);
    ASSERT_EQ(histogram.bins.size(), protocol::kBinBytes);
    EXPECT_EQ(protocol::decode<protocol::Bin>(histogram.bins)->upper, Counted::kNs[i]);
  }
}

TEST(TickReport, TheQuantilesAreThoseOfTheirNames) {
  loop::TickStats stats;
  for (int n = 0; n < 1000; ++n) stats.tick_time.add(n < 985 ? 10 : n < 997 ? 1000 : 100'000);
  stats.tick_time.add(5'000'000);
  const protocol::Quantiles tick = status_report({}, stats, {}).measures[static_cast<std::size_t>(Measure::kTick)];
  EXPECT_EQ(tick.p50, 10U);
  EXPECT_NEAR(tick.p999, 100'000, 100'000 / 16) << "of 1001, the second longest; p99 would be 1000";
  EXPECT_EQ(tick.max, 5'000'000U);
}

TEST(TickReport, EveryCountIsItsOwn) {
  loop::TickStats stats;
  stats.ticks.set(1);
  stats.late.set(2);
  stats.allocations.set(3);
  stats.page_faults.set(4);
  loop::TickRecord newest;
  newest.out.state = 5;
  newest.out.faults = 2;
  newest.faults = 6;  // one of them before a restart
  newest.in.field_generation = 7;
  newest.out.status = kTooFast;
  newest.in.age = 10;
  newest.in.lines = kLineStop;
  const protocol::StatusReport report = status_report(newest, stats, {8, 9, protocol::Text::of("owl"), {}});
  EXPECT_EQ(report.ticks, 1U);
  EXPECT_EQ(report.late, 2U);
  EXPECT_EQ(report.allocations, 3U);
  EXPECT_EQ(report.page_faults, 4U);
  EXPECT_EQ(report.state, 5);
  EXPECT_EQ(report.faults, 6);
  EXPECT_EQ(report.generation, 7U);
  EXPECT_EQ(report.field_hash, 8U);
  EXPECT_EQ(report.field_name.view(), "owl");
  EXPECT_EQ(report.status, kTooFast);
  EXPECT_EQ(report.age, 10);
  EXPECT_EQ(report.lines, kLineStop);
}

}  // namespace
}  // namespace isotouch::control
