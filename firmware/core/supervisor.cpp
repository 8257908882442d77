#include "firmware/core/supervisor.h"

#include <algorithm>

namespace isotouch::core {

namespace {

using S = SupervisorState;

constexpr std::uint32_t kMaxTicks = 1'000'000'000;

constexpr std::uint16_t when(bool condition, Faults fault) { return condition ? std::uint16_t{fault} : std::uint16_t{0}; }

/// Why forces must rest for now.
struct Doubts {
  bool stale, pose, speed, late;
  bool any() const { return stale || pose || speed || late; }
};

Doubts doubts_of(const Observations& seen, const Supervision& limits, const SupervisorMemory& memory) {
  return {seen.stale_ticks >= limits.hold_ticks, !seen.pose_settled, seen.too_fast,
          memory.lateness >= limits.hold_ticks * kLatenessOfAPeriod};
}

/// No step of the state machine leaves such a memory behind: a bit of it was changed since.
bool is_damaged(const SupervisorMemory& memory, S state) {
  return !memory.state.is_whole() || (state == S::kFault) != (memory.faults != 0);
}

/// The causes of a fault in this tick.
std::uint16_t faults_of(const Observations& seen, const Doubts& doubts, const Supervision& limits, const SupervisorMemory& memory,
                        S state) {
  const bool forces = state == S::kActive || state == S::kHold;
  const bool too_long = state == S::kHold && memory.held_ticks >= limits.fault_ticks;
  return static_cast<std::uint16_t>(
      when((seen.requests & kRequestStop) != 0, kFaultStopped) | when(seen.heard && seen.stale_ticks > limits.fault_ticks, kFaultSilent) |
      when(seen.too_deep && state == S::kActive, kFaultPenetration) | when(seen.jumped && seen.homed && forces, kFaultEncoders) |
      when(doubts.pose && too_long, kFaultPose) | when(doubts.speed && too_long, kFaultSpeed) |
      when((doubts.late && too_long) || (forces && (seen.requests & kRequestPaused) != 0), kFaultLate) |
      when((seen.lines & kLineStop) != 0, kFaultEmergency) | when((seen.lines & kLineEnableWrong) != 0, kFaultEnable) |
      when((seen.lines & kLineGuard) != 0, kFaultGuard) | when(is_damaged(memory, state) || (seen.lines & kLineMemory) != 0, kFaultMemory));
}

/// Has the hand pressed one of the model's buttons anew?
bool presses_anew(const Observations& seen, const Supervision& limits, SupervisorMemory& memory) {
  if (seen.stale_ticks > limits.fault_ticks) {  // as before the first packet
    memory.knows_buttons = memory.buttons = memory.steady = 0;
  }
  if (!seen.heard || seen.stale_ticks > 0) return false;
  const int steady = ((seen.buttons ^ memory.shown) & limits.buttons) == 0 ? memory.steady + 1 : 1;
  memory.steady = static_cast<std::uint8_t>(std::min<int>(steady, kSteadyPackets));
  memory.shown = seen.buttons;
  if (memory.steady < kSteadyPackets) return false;
  const bool pressed = memory.knows_buttons != 0 && (seen.buttons & ~memory.buttons & limits.buttons) != 0;
  memory.knows_buttons = 1;
  memory.buttons = seen.buttons;
  return pressed;
}

Finding finding(const Observations& seen, const Doubts& doubts, std::uint16_t faults, bool resumed, const Supervision& limits,
                std::uint8_t held) {
  if (faults != 0) return Finding::kFaulty;
  if (resumed) return Finding::kResumed;
  if (!seen.heard) return Finding::kUnheard;
  if (!seen.homed) return Finding::kUnhomed;
  if (doubts.any()) return Finding::kUncertain;
  if (!seen.has_field) return Finding::kNoField;
  return limits.hold_to_run && (seen.buttons & held & limits.buttons) == 0 ? Finding::kReleased : Finding::kWell;  // let go at once
}

/// The soft start.
Permission ramped(const Supervision& limits, SupervisorMemory& memory) {
  Permission permission;
  permission.granted = true;
  permission.ramping = memory.ramp < limits.ramp_ticks;
  if (permission.ramping) ++memory.ramp;
  permission.part = memory.ramp < limits.ramp_ticks  // at most 2^30
                        ? ForcePart::from_raw(static_cast<std::int32_t>(memory.ramp) * limits.ramp_part.raw())
                        : ForcePart::of(1);
  return permission;
}

}  // namespace

Supervision make_supervision(const DeviceModel& device, std::uint32_t period_ns) {
  Supervision limits;
  limits.hold_ticks = device.hold_ticks;
  limits.fault_ticks = device.fault_age_ns / period_ns;
  limits.ramp_ticks = device.ramp_ticks;
  limits.ramp_part = ForcePart::from_raw(static_cast<std::int32_t>((1U << 30) / device.ramp_ticks));
  limits.buttons = device.buttons;
  limits.hold_to_run = device.hold_to_run != 0;
  return limits;
}

Permission supervise(const Observations& seen, const Supervision& limits, SupervisorMemory& memory) {
  const std::uint32_t most_late = 2 * limits.hold_ticks * kLatenessOfAPeriod;  // after a long pause it is well again within that many ticks
  memory.lateness = seen.late >= kMaxLate ? most_late : std::min(memory.lateness + seen.late * kLatenessOfAPeriod, most_late);
  const Doubts doubts = doubts_of(seen, limits, memory);
  if (memory.lateness > 0) --memory.lateness;

  const bool pressed = presses_anew(seen, limits, memory);
  const bool asks = (seen.requests & kRequestResume) != 0 || pressed;
  const S before = memory.state;
  const std::uint16_t now = faults_of(seen, doubts, limits, memory, before);
  const bool resumed = before == S::kFault && asks && now == 0;
  memory.faults = static_cast<std::uint16_t>(resumed ? 0 : memory.faults | now);
  const S state = next_state(before, finding(seen, doubts, now, resumed, limits, memory.buttons));
  memory.state = state;
  memory.held_ticks = state == S::kHold ? std::min(memory.held_ticks + std::min(seen.late, kMaxTicks) + 1, kMaxTicks) : 0;

  const bool allowed = allows_force(state) && memory.faults == 0 && seen.lines == 0;
  if (allowed && !seen.new_field) return ramped(limits, memory);
  memory.ramp = 0;
  Permission none;
  none.granted = allowed;
  return none;
}

}  // namespace isotouch::core
