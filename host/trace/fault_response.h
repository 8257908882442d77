/// From a condition to no force: in a recording of packets, how many ticks passed from the first one whose input shows that there should be no force
/// to motor commands of zero. What an input shows is judged from the input, not from what the core made of it.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "host/trace/trace_file.h"
#include "shared/tick_io.h"

namespace isotouch::trace {

struct FaultResponse {
  std::uint64_t tick = 0;              ///< the first whose input shows it; in the tick before there were commands, and nothing was shown
  std::string condition;               ///< what is shown, joined by + where several are
  std::optional<std::uint64_t> ticks;  ///< from there to motor commands of zero, 0 = the same tick; nothing: the recording ends before
  SupervisorState state{};             ///< of the tick in which they were zero, else of the last
};

/// All of them, in order. The conditions, with the limits of the recording's device model:
///
///   stop      told to
///   lines     the emergency stop
///   enable    reads back wrong
///   memory    of the tick has changed
///   guard     stopped a motor command
///   stale     no valid fresh packet for hold_ticks
///   late      hold_ticks periods left out before a tick, or one more within three ticks
///   unhomed   a valid packet without homing bits whose counts began anew: all zero, or changed by more than an eighth of count_jump,
///             or whose bits disappeared while ticks were left out
///   jump      a count changed by more than count_jump a tick since the last valid packet
///   leap      by more than half of it, from one tick to the next
///
/// fails     InputError: no outputs in the trace, or no motor command in any tick
std::vector<FaultResponse> fault_responses(const Trace& trace);

}  // namespace isotouch::trace
