/// How long the loop from encoder to motor really takes here, for the certificate of a field.
#pragma once

#include <algorithm>
#include <atomic>
#include <cstdint>

#include "firmware/loop/tick_stats.h"

namespace isotouch::loop {

/// Whole ticks from a sample being taken to the commands made of it being felt: round trip and reply to command, the median of each, in periods; a quarter
/// of a period more is not counted, as the tick does not count it either. From kFew measurements on, then anew after every kWindow: a delay that grows
/// after hours is seen within seconds, and one busy second is no delay.
class MeasuredDelay {
 public:
  static constexpr std::uint64_t kFew = 1'000, kWindow = 10'000;  ///< at 1 kHz a second, and ten

  /// One thread, some times a second.
  void look(const TickStats& stats, std::uint32_t period_ns) {
    const Distribution trips = stats.round_trip.read(), words = stats.word_delay.read();
    const Distribution trip = since(trips_, trips), word = since(words_, words);
    const std::uint64_t measured = std::min(trip.total, word.total);
    if (measured < (is_first_ ? kFew : kWindow)) return;
    const std::uint64_t delay_ns = std::uint64_t{trip.quantile_ns(500'000)} + word.quantile_ns(500'000);
    ticks_ = static_cast<std::uint32_t>((delay_ns + period_ns - period_ns / 4 - 1) / period_ns);
    if (measured < kWindow) return;
    trips_ = trips, words_ = words;
    is_first_ = false;
  }

  /// Another device is measured from now on; what was found holds until something is found of it. The same thread.
  void begin_anew(const TickStats& stats) {
    trips_ = stats.round_trip.read(), words_ = stats.word_delay.read();
    is_first_ = true;
  }

  /// 0: too few were measured. Any thread.
  std::uint32_t ticks() const { return ticks_; }

 private:
  static Distribution since(const Distribution& before, Distribution now) {
    for (std::size_t i = 0; i < now.counts.size(); ++i) now.counts[i] -= before.counts[i];
    now.total -= before.total;
    return now;
  }

  Distribution trips_, words_;  ///< at the window's begin
  bool is_first_ = true;
  std::atomic<std::uint32_t> ticks_{0};
};

}  // namespace isotouch::loop
