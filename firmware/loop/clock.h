/// The seam to time: whoever waits asks a Clock, so tests own it.
#pragma once

#include <cstdint>

namespace isotouch::loop {

/// A clock that never goes back; its zero means nothing.
class Clock {
 public:
  virtual ~Clock() = default;
  virtual std::int64_t now_ns() = 0;
  /// Returns at `when_ns` or later; at once when that is past.
  virtual void sleep_until_ns(std::int64_t when_ns) = 0;
};

}  // namespace isotouch::loop
