/// What a controller does with the hand, as a person needs to be told: what is true, and the next step where there is one. `isotouchd`, the state of its
/// service and the host tool print these sentences.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "shared/protocol_messages.h"
#include "shared/tick_io.h"

namespace isotouch::files {

/// From a tick.
struct Condition {
  std::uint16_t state = 0;   ///< SupervisorState
  std::uint16_t faults = 0;  ///< Faults
  std::uint32_t status = 0;  ///< StatusBits
  bool has_field = false;

  bool operator==(const Condition&) const = default;
};

/// What is true besides while the device that answers has other angles than those in use.
///
/// returns   empty: it has none
std::string_view angles_text(protocol::OtherAngles others);

/// One word: "boot" to "fault"; "unknown" for a number that is no state.
const char* state_name(std::uint16_t state);

/// Begins with that word.
///
/// others    beside it. Unless there are none the device is not heard: its silence is no cause, and nothing resumes it
/// tool      the program that the next step is done with
std::string state_text(const Condition& condition, protocol::OtherAngles others = protocol::OtherAngles::kNone,
                       std::string_view tool = "isotouch");

}  // namespace isotouch::files
