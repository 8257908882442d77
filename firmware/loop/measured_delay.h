/// How long the loop from encoder to motor really takes here, for the certificate of a field.
#pragma once

#include <cstdint>

#include "firmware/loop/tick_stats.h"

namespace isotouch::loop {

/// Whole ticks from a sample being taken to the commands made of it being felt: round trip and reply to command, the median of each, in periods; a quarter
/// of a period more is not counted, as the tick does not count it either.
///
/// returns   0 where fewer than 1000 were measured
inline std::uint32_t measured_delay_ticks(const TickStats& stats, std::uint32_t period_ns) {
  const Distribution trip = stats.round_trip.read(), word = stats.word_delay.read();
  if (trip.total < 1000 || word.total < 1000) return 0;
  const std::uint64_t delay_ns = std::uint64_t{trip.quantile_ns(500'000)} + word.quantile_ns(500'000);
  return static_cast<std::uint32_t>((delay_ns + period_ns - period_ns / 4 - 1) / period_ns);
}

}  // namespace isotouch::loop
