/// An estimate of how warm the motors are, and the limit that follows: the mean square of the commands, averaged over the motors' time constant, is
/// compared with the square of the command that a motor bears for ever. It is a limit, not a fault: forces become weaker, and a status bit reports it.
///
/// source    I²t protection of servo drives; torque is in proportion to current, heat to its square
#pragma once

#include <array>
#include <cstdint>

#include "firmware/core/motor_commands.h"
#include "shared/device_model.h"

namespace isotouch::core {

/// See `make_heat_budget`. Squares of commands have 16 fraction bits.
struct HeatBudget {
  std::int64_t knee = 0;        ///< from here on the limit falls: three quarters of the budget
  std::int64_t quarter = 1;     ///< the rest of it, in whole squares
  std::int64_t of_quarter = 0;  ///< 1 / quarter, 40 fraction bits
  std::int64_t fall = 0;        ///< how far the limit falls there, 8 fraction bits
  std::int64_t forgotten = 0;   ///< part of the heat in one tick, 30 fraction bits
};

/// tick      no: divides
HeatBudget make_heat_budget(const DeviceModel& device, std::uint32_t period_ns);

/// At the start, when the heat is not known, three quarters of the budget are assumed.
struct MotorHeat {
  std::array<std::int64_t, 3> squares{};
  bool has_begun = false;
};

struct CommandLimit {
  Motors motors;         ///< with the limit that holds now, the same for all three
  bool lowered = false;  ///< it is below the model's
};

/// What a tick that forgets everything else is told of the heat: the mean square of the warmest motor's commands, 8 fraction bits, rounded up, so that no
/// motor is taken for cooler than it is.
///
/// returns   at least 1; 0 where no tick has begun, for "not known"
/// fails     never
/// tick      yes
std::uint32_t heat_input(const MotorHeat& heat);

/// The heat that such a tick begins with: all motors are as warm as the warmest was.
///
/// input     as `heat_input` returns it; 0 = not known: three quarters of the budget are assumed
/// fails     never
/// tick      yes
MotorHeat heat_from(std::uint32_t input);

/// The limit of the warmest motor: the model's up to three quarters of the budget, from there on falling in proportion, so that the heat never
/// passes the budget by more than one tick's.
///
/// tick      yes
CommandLimit command_limit(const Motors& motors, const HeatBudget& budget, const MotorHeat& heat);

/// Takes in the commands of a tick.
///
/// tick      yes
void warm(const MotorCommands& commands, const HeatBudget& budget, MotorHeat& heat);

}  // namespace isotouch::core
