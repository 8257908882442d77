/// The interface to time. Everything that waits uses a Clock, so that a test can control the time.
#pragma once

#include <cstdint>

namespace isotouch::loop {

/// A clock that never goes back; only differences of its values have a meaning.
class Clock {
 public:
  virtual ~Clock() = default;
  virtual std::int64_t now_ns() = 0;
  /// Returns at `when_ns` or later; at once when that is past.
  virtual void sleep_until_ns(std::int64_t when_ns) = 0;
  /// How long the machine has slept, all in all: time that this clock does not count. At most too little, never too much.
  virtual std::int64_t suspended_ns() { return 0; }
};

}  // namespace isotouch::loop
