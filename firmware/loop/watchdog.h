/// The watchdog: switches the motors' enable off when ticks stop, when the emergency stop is pressed, or when the supervisor allows no forces. It also
/// reports the state of the lines to the tick, until the supervisor has seen it. A thread with a higher priority than the tick's runs `step` for ever.
///
///   enable      on in ready, active and hold, while ticks come and nothing is pressed
///   heartbeat   changes at every step, as long as ticks come: a relay that needs it opens by itself when the program, the kernel or the processor stops
///   light       on in active, blinks in fault
#pragma once

#include <cstdint>

#include "firmware/loop/clock.h"
#include "firmware/loop/line_state.h"
#include "firmware/loop/safety_lines.h"
#include "firmware/loop/tick_stats.h"

namespace isotouch::loop {

struct WatchdogSettings {
  std::int64_t step_ns = 1'000'000;     ///< between two looks; an edge of the stop ends it early
  std::int64_t silent_ns = 20'000'000;  ///< without a tick until that is one too many
  std::int64_t settle_ns = 50'000'000;  ///< how long the enable may read back otherwise than it was set
};

class Watchdog {
 public:
  /// All of them live longer. ticks: counts the ticks
  Watchdog(const WatchdogSettings& settings, SafetyLines& lines, Clock& clock, LineState& state, const Counter& ticks);
  /// As `leave`.
  ~Watchdog() { leave(); }
  Watchdog(const Watchdog&) = delete;
  Watchdog& operator=(const Watchdog&) = delete;

  /// One look: waits for its time or an edge, reads, judges, tells, sets. Does not allocate.
  void step();

  /// Switches everything off. Called on every way out of the program.
  void leave();

  bool ticks_come() const { return ticks_come_; }
  /// When the stop's line changed last; see `LineInputs`.
  std::int64_t stop_edge_ns() const { return stop_edge_ns_; }

 private:
  bool reads_wrong(bool enabled, std::int64_t now);

  WatchdogSettings settings_;
  SafetyLines& lines_;
  Clock& clock_;
  LineState& state_;
  const Counter& ticks_;
  LineOutputs set_;
  std::uint64_t seen_ = 0;
  std::int64_t next_ns_, ticked_ns_, agreed_ns_, stop_edge_ns_ = 0;
  bool ticks_come_ = false;
  std::uint8_t told_ = 0;
};

}  // namespace isotouch::loop
