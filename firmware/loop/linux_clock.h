/// The machine's monotonic clock.
#pragma once

#include "firmware/loop/clock.h"

namespace isotouch::loop {

/// CLOCK_MONOTONIC; sleeps are absolute, so that being interrupted does not lengthen them. Any thread; no allocation.
class LinuxClock final : public loop::Clock {
 public:
  std::int64_t now_ns() override;
  void sleep_until_ns(std::int64_t when_ns) override;
  /// By CLOCK_BOOTTIME.
  std::int64_t suspended_ns() override;
};

}  // namespace isotouch::loop
