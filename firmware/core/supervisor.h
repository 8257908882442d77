/// Decides whether there may be force: a state machine (`supervisor_table.h`), the conditions that are a fault, and the ramp by which forces return.
///
///   boot → homing → idle → ready → active ⇄ hold        any → fault → (a person) idle
///
/// A limit is not a fault: forces and motor commands that were shortened change no state.
#pragma once

#include <cstdint>

#include "firmware/core/guarded_state.h"
#include "firmware/core/supervisor_table.h"
#include "shared/device_model.h"
#include "shared/tick_io.h"
#include "shared/units.h"

namespace isotouch::core {

/// One part of the ramp. Range ±1.99.
using ForcePart = Fixed<Unit<0, 0, 0, 0>, 30>;

/// Prepared limits, see `make_supervision`.
struct Supervision {
  std::uint32_t hold_ticks = 0;
  std::uint32_t fault_ticks = 0;
  std::uint32_t ramp_ticks = 0;
  ForcePart ramp_part;  ///< 1 / ramp_ticks
  std::uint8_t buttons = 0;
  bool hold_to_run = false;
};

/// tick      no: divides
Supervision make_supervision(const DeviceModel& device, std::uint32_t period_ns);

/// What a tick has found out.
struct Observations {
  bool heard = false;         ///< there was a valid packet
  bool homed = false;         ///< the counts have a reference
  bool jumped = false;        ///< no hand moved the counts as they changed
  bool pose_settled = false;  ///< the HIP is known
  bool has_field = false;
  bool new_field = false;         ///< another field than in the tick before
  bool too_deep = false;          ///< beyond the penetration limit
  bool too_fast = false;          ///< beyond the speed limit
  std::uint32_t stale_ticks = 0;  ///< since the last valid fresh packet; 0: this tick has one
  std::uint32_t late = 0;         ///< periods left out before this tick
  std::uint8_t lines = 0;         ///< LineBits
  std::uint8_t buttons = 0;       ///< of the newest valid packet
  std::uint8_t requests = 0;      ///< RequestBits
};

struct SupervisorMemory {
  GuardedState state;
  std::uint16_t faults = 0;
  std::uint8_t knows_buttons = 0;  ///< 1: so many packets have come since the first; before, no button is held, and none is pressed
  std::uint8_t buttons = 0;        ///< as the hand holds them, see kSteadyPackets
  std::uint8_t shown = 0;          ///< as the newest valid packet shows them
  std::uint8_t steady = 0;         ///< valid packets in a row that show the same of the model's buttons, at most kSteadyPackets
  std::uint32_t ramp = 0;          ///< ticks of the ramp done
  std::uint32_t lateness = 0;      ///< see `supervise`
  std::uint32_t held_ticks = 0;    ///< in hold, in a row, with those that were left out, of each pause at most kMaxLate
};

/// Is a person needed before force may return? Also if the memory contradicts itself.
constexpr bool is_in_fault(const SupervisorMemory& memory) { return memory.state == SupervisorState::kFault || memory.faults != 0; }

/// How much of the force is allowed: none but in kActive without a fault and with good lines, there all of it once the ramp is done.
struct Permission {
  bool granted = false;
  bool ramping = false;
  ForcePart part;
};

/// Lateness is a leaky bucket: each missed period adds 8, each tick removes 1, and kMaxLate is the most that it holds. Hold begins at 8 times hold_ticks,
/// after one tick that is that late or after several that are a little late.
inline constexpr std::uint32_t kLatenessOfAPeriod = 8;

/// A hand holds what so many valid packets in a row show, and lets go of what none of so many shows: 8 ms at the device's rate. No press is as short; and a
/// packet with a wrong bit, or a contact that bounces, resumes nothing.
inline constexpr std::uint8_t kSteadyPackets = 8;

/// One step of the state machine. A cause of fault goes before everything else. The fault stays until its cause is gone and a person resumes: by
/// kRequestResume, or by pressing one of the model's buttons anew. A hold longer than the fault age becomes a fault, and so does what the loop
/// calls a pause. So does a memory that contradicts itself: a state that is none, a fault without a reason, or a reason without a fault.
///
/// tick      yes
Permission supervise(const Observations& seen, const Supervision& limits, SupervisorMemory& memory);

}  // namespace isotouch::core
