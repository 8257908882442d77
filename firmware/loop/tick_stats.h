/// What the loop counts, always: how the ticks began, how long things took. Written by the tick, read by anyone at any time without a lock.
#pragma once

#include <atomic>
#include <cstdint>

#include "firmware/loop/histogram.h"

namespace isotouch::loop {

/// A number with one writer and any number of readers.
class Counter {
  static_assert(std::atomic<std::uint64_t>::is_always_lock_free);

 public:
  /// tick      yes
  void add(std::uint64_t by = 1) { value_.store(value() + by, std::memory_order_relaxed); }
  void set(std::uint64_t to) { value_.store(to, std::memory_order_relaxed); }
  std::uint64_t value() const { return value_.load(std::memory_order_relaxed); }

 private:
  std::atomic<std::uint64_t> value_{0};
};

struct TickStats {
  Counter ticks;
  Counter fresh;         ///< ticks with a sample that no tick had seen
  Counter stale;         ///< ticks without
  Counter by_reply;      ///< ticks that a reply started
  Counter late;          ///< ticks that began a period or more after they were due
  Counter missed;        ///< whole periods in which no tick began
  Counter samples_lost;  ///< samples that came and went between two ticks
  Counter largest_age;   ///< of a sample, in ticks, since the first one
  Counter field_swaps;   ///< fields taken over
  Counter page_faults;   ///< of the tick thread since its first tick; read once in `Loop::kFaultsEvery` ticks
  Counter allocations;   ///< of the tick thread since its first tick; stays 0 unless the program counts them

  Histogram wake_delay;  ///< from when a tick should begin (its reply's arrival, or its due time) to its begin
  Histogram tick_time;   ///< from its begin to the commands being left
  Histogram round_trip;  ///< of the device: command handed over to reply there
  Histogram word_delay;  ///< sensor to command: a reply there to the commands made of it being handed over
};

}  // namespace isotouch::loop
