#include "firmware/core/supervisor.h"

#include <array>
#include <cstddef>

namespace isotouch::core {

namespace {

using S = SupervisorState;

/// What a tick found, the gravest first.
enum class Finding : std::uint8_t { kFaulty, kUnheard, kUnhomed, kUncertain, kNoField, kWell };

/// The next state, by state and finding.
constexpr std::array<std::array<S, 6>, 7> kNext = {{
    //            faulty     unheard    unhomed     uncertain   no field    well
    /* boot   */ {S::kFault, S::kBoot, S::kHoming, S::kHoming, S::kHoming, S::kHoming},
    /* homing */ {S::kFault, S::kBoot, S::kHoming, S::kHoming, S::kIdle, S::kIdle},
    /* idle   */ {S::kFault, S::kBoot, S::kHoming, S::kIdle, S::kIdle, S::kReady},
    /* ready  */ {S::kFault, S::kBoot, S::kHoming, S::kIdle, S::kIdle, S::kActive},
    /* active */ {S::kFault, S::kBoot, S::kHoming, S::kHold, S::kIdle, S::kActive},
    /* hold   */ {S::kFault, S::kBoot, S::kHoming, S::kHold, S::kIdle, S::kActive},
    /* fault  */ {S::kFault, S::kFault, S::kFault, S::kFault, S::kFault, S::kFault},
}};

constexpr std::uint16_t when(bool condition, Faults fault) { return condition ? std::uint16_t{fault} : std::uint16_t{0}; }

/// The causes of a fault in this tick.
std::uint16_t faults_of(const Observations& seen, const Supervision& limits, const SupervisorMemory& memory) {
  const bool stopped = (seen.commands & kCommandStop) != 0;
  const bool silent = seen.heard && seen.stale_ticks > limits.fault_ticks;
  const bool too_deep = seen.too_deep && memory.state == S::kActive;
  return static_cast<std::uint16_t>(when(stopped, kFaultStopped) | when(silent, kFaultSilent) | when(too_deep, kFaultPenetration));
}

Finding finding(const Observations& seen, const Supervision& limits, std::uint16_t faults) {
  if (faults != 0) return Finding::kFaulty;
  if (!seen.heard) return Finding::kUnheard;
  if (!seen.homed) return Finding::kUnhomed;
  if (!seen.pose_settled || seen.stale_ticks >= limits.hold_ticks) return Finding::kUncertain;
  return seen.has_field ? Finding::kWell : Finding::kNoField;
}

}  // namespace

Supervision make_supervision(const DeviceModel& device, std::uint32_t period_ns) {
  Supervision limits;
  limits.hold_ticks = device.hold_ticks;
  limits.fault_ticks = device.fault_age_ns / period_ns;
  limits.ramp_ticks = device.ramp_ticks;
  limits.ramp_part = ForcePart::from_raw(static_cast<std::int32_t>((1U << 30) / device.ramp_ticks));
  return limits;
}

Permission supervise(const Observations& seen, const Supervision& limits, SupervisorMemory& memory) {
  const std::uint16_t now = faults_of(seen, limits, memory);
  if (memory.state == S::kFault && now == 0 && (seen.commands & kCommandResume) != 0) {
    memory.state = S::kIdle;
    memory.faults = 0;
  }
  memory.faults = static_cast<std::uint16_t>(memory.faults | now);
  memory.state = kNext[static_cast<std::size_t>(memory.state)][static_cast<std::size_t>(finding(seen, limits, now))];

  Permission permission;
  permission.granted = memory.state == S::kActive;
  if (!permission.granted || seen.new_field) {
    memory.ramp = 0;
    return permission;
  }
  permission.ramping = memory.ramp < limits.ramp_ticks;
  if (permission.ramping) ++memory.ramp;
  permission.part = memory.ramp < limits.ramp_ticks  // at most 2^30
                        ? ForcePart::from_raw(static_cast<std::int32_t>(memory.ramp) * limits.ramp_part.raw())
                        : ForcePart::of(1);
  return permission;
}

}  // namespace isotouch::core
