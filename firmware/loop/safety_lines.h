/// The interface to four lines beside the device: an emergency stop, the motors' enable with its read-back, a heartbeat for an external watchdog relay, and a
/// light. Used by one thread, the watchdog's.
#pragma once

#include <cstdint>

namespace isotouch::loop {

struct LineInputs {
  bool stop = false;              ///< pressed, or its wire is broken, or it cannot be read
  bool enabled = false;           ///< as read back; where nothing is read back, as it was set
  std::int64_t stop_edge_ns = 0;  ///< when the stop's line changed last, by the kernel, CLOCK_MONOTONIC; 0 = never
};

struct LineOutputs {
  bool enable = false;     ///< the motors may have power
  bool heartbeat = false;  ///< changes as long as ticks come
  bool light = false;

  bool operator==(const LineOutputs&) const = default;
};

class SafetyLines {
 public:
  virtual ~SafetyLines() = default;

  /// Returns at `until_ns`, or as soon as the stop's line has changed.
  virtual void wait(std::int64_t until_ns) = 0;

  /// fails     never: a line that cannot be read is a stop
  virtual LineInputs read() = 0;

  virtual void set(const LineOutputs& outputs) = 0;
};

}  // namespace isotouch::loop
