/// What other threads ask of the tick, kept until the next tick begins. Any number of askers.
#pragma once

#include <atomic>
#include <cstdint>

#include "shared/device_io.h"

namespace isotouch::loop {

class Commands {
 public:
  /// bits      DeviceCommands; added to what is asked already
  void ask(std::uint8_t bits) { asked_.fetch_or(bits, std::memory_order_acq_rel); }

  /// All that was asked since the last tick, and nothing is asked any more.
  ///
  /// tick      yes
  std::uint8_t take() {
    return asked_.load(std::memory_order_relaxed) == 0 ? std::uint8_t{0} : asked_.exchange(0, std::memory_order_acq_rel);
  }

 private:
  std::atomic<std::uint8_t> asked_{0};
};

}  // namespace isotouch::loop
