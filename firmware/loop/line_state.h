/// What the watch thread and the tick tell each other: what the safety lines say, and what the supervisor allows.
#pragma once

#include <atomic>
#include <cstdint>

#include "shared/device_io.h"

namespace isotouch::loop {

/// Without a watch nothing is ever wrong.
class LineState {
  static_assert(std::atomic<std::uint16_t>::is_always_lock_free);

 public:
  /// The watch's side. bits: DeviceLines
  void put(std::uint8_t bits) { bits_.store(bits, std::memory_order_release); }
  SupervisorState told() const { return static_cast<SupervisorState>(state_.load(std::memory_order_acquire)); }

  /// tick      yes
  std::uint8_t get() const { return bits_.load(std::memory_order_acquire); }
  /// tick      yes
  void tell(std::uint16_t state) { state_.store(state, std::memory_order_release); }

 private:
  std::atomic<std::uint8_t> bits_{0};
  std::atomic<std::uint16_t> state_{0};
};

}  // namespace isotouch::loop
