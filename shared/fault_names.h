/// Why there is no force, in words: the one table that the controller and the host tool print.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

#include "shared/tick_io.h"

namespace isotouch {

struct FaultName {
  std::uint16_t fault;        ///< one of Faults
  std::string_view name;      ///< for programs
  std::string_view sentence;  ///< what happened, and what to do before it is resumed
};

/// Faults after which a person has to look at lines, board or program before anybody resumes.
inline constexpr std::uint16_t kServiceFaults = kFaultEmergency | kFaultEnable | kFaultMemory | kFaultGuard;

inline constexpr std::array<FaultName, 11> kFaultNames = {{
    {kFaultStopped, "stopped",
     "a stop was requested, or the controller began anew after a crash, a stop or a fault, or with changed angles; its own output says "
     "which (journalctl -u isotouchd); check the grip"},
    {kFaultSilent, "silent", "the device did not answer in time; check its cable and power supply"},
    {kFaultPenetration, "penetration", "the hand was too deep in the object; let go, and move out of it"},
    {kFaultEncoders, "encoders", "the encoders jumped while there was force; unplug the device, so that it is homed again"},
    {kFaultPose, "pose", "the grip was where the arms cannot reach; check geometry and homing of the device"},
    {kFaultSpeed, "speed", "the grip moved too fast for too long; hold it still"},
    {kFaultLate, "late", "ticks came too late for too long; give the controller its priority and a core, or a lower rate"},
    {kFaultEmergency, "emergency", "the emergency stop is pressed, its wire is broken, or the watchdog no longer reads it; release it"},
    {kFaultEnable, "enable", "the enable line of the motors does not read back as it was set; check its relay and wires"},
    {kFaultMemory, "memory",
     "the controller's memory was damaged; restart the controller, and test the board's memory if it happens again"},
    {kFaultGuard, "guard",
     "the guard took the force away, because a motor command contradicted the device's own packets; let go, and restart the controller if "
     "it "
     "happens again"},
}};

/// The guard's verdicts by number, as `isotouchd` and `trace show` print them.
inline constexpr std::array<std::string_view, kGuardVerdicts> kGuardVerdictNames = {
    "none",
    "above a motor's limit",
    "while a safety line was bad",
    "while the light showed no force",
    "without a reference of the encoders",
    "after a jump of the encoders",
    "without new packets",
    "without a button that must be held",
    "for a hand that is too fast",
    "for a position that the arms cannot reach",
    "for motors that are too warm",
    "while the hand touched nothing",
    "stronger than the hand's movement explains",
    "into the object",
    "that did not change while the hand moved",
    "after a stop",
    "while an encoder did not move",
    "after its own memory was damaged",
};

constexpr std::string_view name_of(GuardVerdict verdict) {
  const auto number = static_cast<std::size_t>(verdict);
  return number < kGuardVerdicts ? kGuardVerdictNames[number] : "for an unknown reason";
}

}  // namespace isotouch
