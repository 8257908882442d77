/// The supervisor's whole behaviour as data: for each state and each finding of a tick, the next state. A test walks every entry.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "shared/tick_io.h"

namespace isotouch::core {

inline constexpr std::size_t kStates = 7;

/// What a tick found, the gravest first: the first that holds counts.
enum class Finding : std::uint8_t {
  kFaulty,     ///< a cause of fault
  kResumed,    ///< in fault alone: its cause is gone and a person asks to go on
  kUnheard,    ///< no valid packet yet
  kUnhomed,    ///< the counts have no reference
  kUncertain,  ///< samples are missing, ticks late, the pose unknown or the hand too fast
  kNoField,
  kReleased,  ///< a button must be held, and is not
  kWell,
};
inline constexpr std::size_t kFindings = 8;

namespace supervisor_table_detail {
using enum SupervisorState;

/// Rows are states, columns findings.
// clang-format off
inline constexpr std::array<std::array<SupervisorState, kFindings>, kStates> kNext = {{
    //            faulty   resumed  unheard  unhomed  uncertain no field released well
    /* boot   */ {{kFault,  kFault,  kBoot,   kHoming, kHoming,  kHoming, kHoming, kHoming}},
    /* homing */ {{kFault,  kFault,  kBoot,   kHoming, kHoming,  kIdle,   kIdle,   kIdle}},
    /* idle   */ {{kFault,  kFault,  kBoot,   kHoming, kIdle,    kIdle,   kReady,  kReady}},
    /* ready  */ {{kFault,  kFault,  kBoot,   kHoming, kIdle,    kIdle,   kReady,  kActive}},
    /* active */ {{kFault,  kFault,  kBoot,   kHoming, kHold,    kIdle,   kReady,  kActive}},
    /* hold   */ {{kFault,  kFault,  kBoot,   kHoming, kHold,    kIdle,   kReady,  kActive}},
    /* fault  */ {{kFault,  kIdle,   kFault,  kFault,  kFault,   kFault,  kFault,  kFault}},
}};
// clang-format on
}  // namespace supervisor_table_detail

/// fails     never: a state or finding that is none leads to kFault
/// tick      yes
constexpr SupervisorState next_state(SupervisorState state, Finding finding) {
  const auto row = static_cast<std::size_t>(state), column = static_cast<std::size_t>(finding);
  return row < kStates && column < kFindings ? supervisor_table_detail::kNext[row][column] : SupervisorState::kFault;
}

/// May there be motor commands other than zero?
constexpr bool allows_force(SupervisorState state) { return state == SupervisorState::kActive; }

}  // namespace isotouch::core
