#include "firmware/control/tick_report.h"

#include <algorithm>

namespace isotouch::control {

namespace {

const loop::Histogram& histogram(protocol::Measure measure, const loop::TickStats& stats) {
  switch (measure) {
    case protocol::Measure::kWakeup: return stats.wake_delay;
    case protocol::Measure::kTick: return stats.tick_time;
    case protocol::Measure::kRoundTrip: return stats.round_trip;
    default: return stats.word_delay;
  }
}

}  // namespace

protocol::StatusReport status_report(const loop::TickRecord& newest, const loop::TickStats& stats, const store::PublishedField& field) {
  protocol::StatusReport report;
  report.state = newest.out.state;
  report.faults = newest.faults;
  report.generation = newest.in.field_generation;
  report.ticks = stats.ticks.value();
  report.late = stats.late.value();
  report.field_hash = field.image_hash;
  report.field_name = field.name;
  report.status = newest.out.status;
  report.age = newest.in.age;
  report.lines = newest.in.lines;
  report.allocations = stats.allocations.value();
  report.page_faults = stats.page_faults.value();
  for (std::size_t i = 0; i < protocol::kMeasures; ++i) {
    const loop::Distribution seen = histogram(static_cast<protocol::Measure>(i), stats).read();
    report.measures[i] = {seen.quantile_ns(500'000), seen.quantile_ns(999'000), seen.largest_ns};
  }
  return report;
}

protocol::HistogramReport histogram_report(protocol::Measure measure, const loop::TickStats& stats, std::span<std::uint8_t> scratch) {
  const loop::Distribution seen = histogram(measure, stats).read();
  protocol::BodyWriter bins(scratch);
  for (std::size_t i = 0; i < seen.counts.size(); ++i) {
    if (seen.counts[i] == 0) continue;
    const protocol::Bin bin{std::min(loop::histogram_layout::upper_ns(i), seen.largest_ns), seen.counts[i]};
    protocol::Bin::fields(bin, bins);
  }
  return {static_cast<std::uint8_t>(measure), seen.total, scratch.first(bins.used())};
}

protocol::WorstTicks worst_report(const WorstTicks& worst, std::span<std::uint8_t> scratch) {
  protocol::BodyWriter ticks(scratch);
  for (const protocol::WorstTick& tick : worst.ticks()) protocol::WorstTick::fields(tick, ticks);
  return {worst.seen(), scratch.first(ticks.used())};
}

}  // namespace isotouch::control
