/// Arm torques → motor commands, within what the motors take.
#pragma once

#include <cstdint>

#include "firmware/core/joint_torques.h"
#include "shared/device_model.h"
#include "shared/tick_io.h"

namespace isotouch::core {

/// See `make_motors`.
struct Motors {
  std::int32_t units_per_newton_mm = 0;  ///< 1 / k, 20 fraction bits
  std::int32_t limit = 0;                ///< of a command, 8 fraction bits
  std::int32_t slew = 0;                 ///< of a command's change in a tick, 8 fraction bits
};

/// tick      no: divides
Motors make_motors(const DeviceModel& device, std::uint32_t period_ns);

struct Commanded {
  MotorCommands commands{};
  bool limited = false;       ///< all three were shortened by one factor so that the largest is at the limit
  bool slew_limited = false;  ///< the change since the last commands was shortened by one factor
};

/// u = -τ / k: a positive command turns the arm inwards. Where a command or its change is too large, all three are scaled by one factor, so that the
/// direction is kept.
///
/// last      the commands of the last tick; zero after rest
/// returns   within 1 unit of the exact ones
/// fails     never
/// tick      yes
Commanded motor_commands(const JointTorques& torques, const Motors& motors, const MotorCommands& last);

}  // namespace isotouch::core
