/// The last word on every force: a small machine of states, and the ramp by which forces return after rest.
///
///   boot → homing → idle → ready → active ⇄ hold        any → fault → (resume) idle
///
/// What else may forbid a force (safety lines, motor heat, speed) becomes a member of `Observations` and a row of `faults_of`.
#pragma once

#include <cstdint>

#include "shared/device_io.h"
#include "shared/device_model.h"
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
};

/// tick      no: divides
Supervision make_supervision(const DeviceModel& device, std::uint32_t period_ns);

/// What the tick knows when it asks.
struct Observations {
  bool heard = false;         ///< there was a valid packet
  bool homed = false;         ///< the counts have a reference
  bool pose_settled = false;  ///< the HIP is known
  bool has_field = false;
  bool new_field = false;         ///< another field than in the tick before
  bool too_deep = false;          ///< beyond the penetration limit
  std::uint32_t stale_ticks = 0;  ///< since the last valid fresh packet
  std::uint8_t commands = 0;      ///< DeviceCommands
};

struct SupervisorMemory {
  SupervisorState state = SupervisorState::kBoot;
  std::uint16_t faults = 0;
  std::uint32_t ramp = 0;  ///< ticks of the ramp done
};

/// How much of the force is allowed: none but in kActive, there all of it once the ramp is done.
struct Permission {
  bool granted = false;
  bool ramping = false;
  ForcePart part;
};

/// One step of the machine. A cause of fault outweighs everything, and stays until it is gone and kCommandResume is given.
///
/// tick      yes
Permission supervise(const Observations& seen, const Supervision& limits, SupervisorMemory& memory);

}  // namespace isotouch::core
