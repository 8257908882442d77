/// What the safety lines tell, from the watch thread to the tick.
#pragma once

#include <atomic>
#include <cstdint>

#include "shared/device_io.h"

namespace isotouch::loop {

/// Before the first `put`, and where no lines are, nothing is wrong. Any number of readers.
class LineState {
  static_assert(std::atomic<std::uint8_t>::is_always_lock_free);

 public:
  /// bits      DeviceLines
  void put(std::uint8_t bits) { bits_.store(bits, std::memory_order_release); }
  /// tick      yes
  std::uint8_t get() const { return bits_.load(std::memory_order_acquire); }

 private:
  std::atomic<std::uint8_t> bits_{0};
};

}  // namespace isotouch::loop
