/// What enters one tick and what leaves it: the arguments of the pure function, and so the content of a trace's record.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "shared/falcon_packet.h"
#include "shared/tick_settings.h"
#include "shared/units.h"
#include "shared/vec3.h"

namespace isotouch {

/// What an input knows of the hand.
enum class InputKind : std::uint8_t {
  kPosition = 0,  ///< where it is: a hand without a device
  kPacket = 1,    ///< what the device sent
};

/// What a person or the loop asks of the tick; each bit holds for the tick in which it stands.
enum RequestBits : std::uint8_t {
  kRequestStop = 1U << 0,     ///< no force from this tick on: fault "stopped"
  kRequestResume = 1U << 1,   ///< leave the state fault, if its cause is gone
  kRequestRestart = 1U << 2,  ///< forget everything before this tick but `Input::heat`: a recording that begins here replays
  kRequestMoved = 1U << 3,    ///< the field is that of the tick before, patched: the surface moved. Never with a restart or a change
  kRequestPaused =
      1U
      << 4,  ///< the loop: a pause before this tick, or a hold with the pauses in it, is longer than a hold may last; ends force with a fault
};

/// What stands beside the tick and may forbid forces. Bits 0 and 1: the safety lines, already judged by `loop/watchdog.h`; without lines neither is ever
/// set. Bit 2: the memory. Bits 3 to 7: the guard's verdict.
enum LineBits : std::uint8_t {
  kLineStop = 1U << 0,         ///< the emergency stop is pressed, its wire is broken, or nobody reads it
  kLineEnableWrong = 1U << 1,  ///< the motors' enable does not read back as it was set
  kLineMemory = 1U << 2,       ///< memory that the tick relies on has changed, see `loop/memory_check.h`
  kLineGuard = 0x1FU << 3,     ///< a GuardVerdict: its lower four bits in bits 4 to 7, its fifth in bit 3
};

/// Why the guard has taken the force away: a motor command, other than zero, contradicts what it reads in the device's packets itself.
enum class GuardVerdict : std::uint8_t {
  kNone = 0,
  kLimit,      ///< a command beyond the motor's limit
  kLine,       ///< while a safety line is bad, or memory damaged
  kLight,      ///< while the light shows that there is no force
  kReference,  ///< the encoders have no reference
  kJump,       ///< their counts jumped
  kStale,      ///< no valid packet came
  kReleased,   ///< no button is held, though one must be
  kSpeed,      ///< the hand is too fast
  kPose,       ///< no place that the arms reach
  kHeat,       ///< the motors are warmer than they bear
  kFree,       ///< the hand touches nothing
  kStrong,     ///< a force beyond what the hand's way, the stiffness and the limits explain
  kPull,       ///< a force into the object
  kRepeat,     ///< the same commands again and again, though the hand moves
  kStopped,    ///< a stop was requested, and nobody has resumed
  kStuck,      ///< an encoder does not move, though the hand or the force does
  kMemory,     ///< what the guard remembers has changed
};
inline constexpr std::size_t kGuardVerdicts = 18;

/// returns   of bits that no verdict has, a number that is none
constexpr GuardVerdict guard_verdict(std::uint8_t lines) { return static_cast<GuardVerdict>(lines >> 4 | (lines & 8) << 1); }
constexpr std::uint8_t line_bits(GuardVerdict verdict) {
  const auto number = static_cast<unsigned>(verdict);
  return static_cast<std::uint8_t>((number & 15) << 4 | (number & 16) >> 1);
}

/// Largest number of periods that `Input::late` counts.
inline constexpr std::uint8_t kMaxLate = 31;

/// Who changed something while it was felt: the number of the user plus 1.
inline constexpr std::uint32_t kNobody = 0;  ///< the controller itself, or somebody who is not known
constexpr std::uint32_t author_of(std::uint32_t user) { return user + 1; }
constexpr std::uint32_t user_of(std::uint32_t author) { return author - 1; }

/// Everything that a tick gets to know. Arrival times stay outside: they are not the same twice.
struct Input {
  InputKind kind = InputKind::kPacket;
  bool fresh = false;              ///< false: the same sample as in an earlier tick, or none yet
  std::uint8_t lines = 0;          ///< LineBits, the guard's verdict among them
  std::uint8_t late = 0;           ///< whole periods that were left out since the tick before; kMaxLate = that many or more
  std::uint8_t requests = 0;       ///< RequestBits
  std::uint16_t age = 0;           ///< whole ticks since the sample was fresh
  SettingChange change;            ///< what a person set anew
  std::uint32_t author = kNobody;  ///< who made the requests, else who sent the new field, else who made the change; the tick ignores it
  std::uint32_t heat = 0;          ///< only with kRequestRestart and without a change, see `core::heat_input`; 0 = not known
  std::uint32_t moved_to = 0;      ///< only with kRequestMoved: the lower half of the hash of the image from now on; the tick ignores it
  std::uint32_t field_generation = 0;  ///< 0 = no field; another number than in the tick before = another field, or a patched one
  FalconPacket packet{};               ///< kPacket: the newest reply, as it came; all zero before the first
  Vec3<Mm> hip;                        ///< kPosition: workspace frame
  std::uint8_t buttons = 0;            ///< kPosition: bits 0 to 3

  bool operator==(const Input&) const = default;
};

/// A fresh sample of a hand without a device, in a field that is loaded.
constexpr Input position_input(const Vec3<Mm>& hip) {
  Input in;
  in.kind = InputKind::kPosition;
  in.fresh = true;
  in.field_generation = 1;
  in.hip = hip;
  return in;
}

/// Conditions of one tick; "limited" bits are not faults.
enum StatusBits : std::uint32_t {
  kContact = 1U << 0,       ///< the proxy is held by the surface, the force is that of contact
  kFollowing = 1U << 1,     ///< the proxy is on its way to the HIP in free space and has not arrived: no force
  kOutsideGrid = 1U << 2,   ///< the HIP is outside the sampled box
  kHeldInside = 1U << 3,    ///< the HIP began inside the object: no force until it has left
  kRamping = 1U << 4,       ///< the force is below its full value because contact did not begin at rest
  kForceLimited = 1U << 5,  ///< the force was shortened to the limit, its direction kept
  kStale = 1U << 6,         ///< the input was not fresh
  kInputClamped = 1U << 7,  ///< the HIP was outside ±512 mm and was moved to the border
  // Only with a device.
  kBadReply = 1U << 8,          ///< the packet was malformed and counts as none
  kCountJump = 1U << 9,         ///< the counts took another reference: the pose is sought anew
  kPoseUncertain = 1U << 10,    ///< the HIP is not known: no force
  kNearSingular = 1U << 11,     ///< the mechanism is nearly singular: torques are smaller than asked for
  kTooFast = 1U << 12,          ///< the HIP is faster than the model's limit
  kCommandsLimited = 1U << 13,  ///< the motor commands were shortened to the limit, their direction kept
  kSlewLimited = 1U << 14,      ///< the change of the motor commands was shortened, its direction kept
  kHeatLimited = 1U << 20,      ///< the limit of the motor commands is lowered, because the motors are warm
  kLate = 1U << 21,             ///< periods were left out before this tick
  // Of how it feels.
  kDamped = 1U << 24,   ///< the passivity controller adds damping
  kLagging = 1U << 25,  ///< the surface has moved by itself, and the force has not followed yet; without kContact it is being released
};

/// What the supervisor allows. Motor commands are zero in every state but kActive.
enum class SupervisorState : std::uint16_t {
  kBoot = 0,    ///< no valid packet yet
  kHoming = 1,  ///< the counts have no reference: the grip must be pulled out and pushed in once
  kIdle = 2,    ///< the pose is known, no field
  kReady = 3,   ///< a field is loaded; active in the next tick, or as long as a button is held
  kActive = 4,  ///< forces
  kHold = 5,    ///< samples missing, ticks late, pose uncertain or hand too fast: no force; leaves by itself, forces rise by a ramp
  kFault = 6,   ///< no force until a person resumes: kRequestResume, or a button pressed anew
};

/// Why the supervisor is in fault; kept until it is resumed.
enum Faults : std::uint16_t {
  kFaultStopped = 1U << 0,      ///< kRequestStop
  kFaultSilent = 1U << 1,       ///< no valid fresh packet for longer than the model's fault age
  kFaultPenetration = 1U << 2,  ///< the hand is further from the proxy than the model's limit
  kFaultEncoders = 1U << 3,     ///< the counts jumped while there were forces
  kFaultPose = 1U << 4,         ///< the pose was uncertain for longer than the fault age: no place that the mechanism reaches
  kFaultSpeed = 1U << 5,        ///< the hand was too fast for longer than the fault age
  kFaultLate = 1U << 6,         ///< ticks were late for longer than the fault age, or one was by so much
  kFaultEmergency = 1U << 7,    ///< kLineStop
  kFaultEnable = 1U << 8,       ///< kLineEnableWrong
  kFaultMemory = 1U << 9,       ///< what the supervisor remembered contradicted itself, or kLineMemory
  kFaultGuard = 1U << 10,       ///< the guard took the force away, see GuardVerdict
};

using MotorCommands = std::array<std::int16_t, 3>;

constexpr bool is_zero(const MotorCommands& commands) { return commands == MotorCommands{}; }

/// Everything that a tick answers. Of a hand without a device: HIP, proxy, force, status and buttons; the rest is zero.
struct Output {
  Vec3<Mm> hip;                   ///< workspace frame; zero while the pose is not known
  Vec3<Mm> proxy;                 ///< workspace frame
  Vec3<Newton> force;             ///< on the hand, device axes; what the motor commands ask for, before their limits
  MotorCommands commands{};       ///< motor commands, legs 1 to 3
  std::uint16_t state = 0;        ///< SupervisorState
  std::uint32_t status = 0;       ///< StatusBits
  std::uint16_t faults = 0;       ///< Faults
  std::uint8_t packet_flags = 0;  ///< FalconFlags of the next command packet
  std::uint8_t buttons = 0;       ///< bits 0 to 3 of the newest valid packet

  bool operator==(const Output&) const = default;
};

/// Did the tick render a force as it is felt? A position's always did, a device's only in the state active.
constexpr bool may_give_force(InputKind kind, const Output& out) {
  return kind == InputKind::kPosition || out.state == static_cast<std::uint16_t>(SupervisorState::kActive);
}

}  // namespace isotouch
