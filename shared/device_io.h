/// What enters one tick of a device and what leaves it: `tick_io.h` at the wire. The content of a trace record of major version 2.
#pragma once

#include <cstdint>

#include "shared/falcon_packet.h"
#include "shared/setting_change.h"
#include "shared/tick_io.h"
#include "shared/units.h"
#include "shared/vec3.h"

namespace isotouch {

/// What a person or the loop asks of the tick; each bit holds for the tick in which it stands.
enum DeviceCommands : std::uint8_t {
  kCommandStop = 1U << 0,     ///< no force from this tick on: fault "stopped"
  kCommandResume = 1U << 1,   ///< leave the state fault, if its cause is gone
  kCommandRestart = 1U << 2,  ///< forget everything before this tick: a recording that begins here replays
};

/// What the safety lines tell, already judged; see `loop/watch.h`. Without lines none is ever set.
enum DeviceLines : std::uint8_t {
  kLineStop = 1U << 0,         ///< the emergency stop is pressed, its wire is broken, or nobody reads it
  kLineEnableWrong = 1U << 1,  ///< the motors' enable does not read back as it was set
};

/// Most periods that `DeviceInput::late` counts.
inline constexpr std::uint8_t kMostLate = 31;

/// The wire as the loop sees it at the start of a tick. Arrival times stay outside: they are not the same twice.
struct DeviceInput {
  FalconPacket packet{};               ///< the newest reply, as it came; all zero before the first
  bool fresh = false;                  ///< false: the same packet as in an earlier tick, or none yet
  std::uint16_t age = 0;               ///< whole ticks since the packet was fresh
  std::uint8_t commands = 0;           ///< DeviceCommands
  std::uint32_t field_generation = 0;  ///< 0 = no field; another number than in the tick before = another field
  std::uint8_t lines = 0;              ///< DeviceLines
  std::uint8_t late = 0;               ///< whole periods that were left out since the tick before, kMostLate = so many or more
  SettingChange change;                ///< what a person set anew

  bool operator==(const DeviceInput&) const = default;
};

/// What the supervisor allows. Motor words are zero in every state but kActive.
enum class SupervisorState : std::uint16_t {
  kBoot = 0,    ///< no valid packet yet
  kHoming = 1,  ///< the counts have no reference: the grip must be pulled out and pushed in once
  kIdle = 2,    ///< the pose is known, no field
  kReady = 3,   ///< a field is loaded; active in the next tick, or as long as a button is held
  kActive = 4,  ///< forces
  kHold =
      5,  ///< samples are missing, ticks late, the pose uncertain or the hand too fast: no force; leaves by itself, forces rise by a ramp
  kFault = 6,  ///< no force until a person resumes: kCommandResume, or a button pressed anew
};

/// Why the supervisor is in fault; kept until it is resumed.
enum Faults : std::uint16_t {
  kFaultStopped = 1U << 0,      ///< kCommandStop
  kFaultSilent = 1U << 1,       ///< no valid fresh packet for longer than the model's fault age
  kFaultPenetration = 1U << 2,  ///< the hand is further from the proxy than the model's limit
  kFaultEncoders = 1U << 3,     ///< the counts jumped while there were forces
  kFaultPose = 1U << 4,         ///< the pose was uncertain for longer than the fault age: no place that the mechanism reaches
  kFaultSpeed = 1U << 5,        ///< the hand was too fast for longer than the fault age
  kFaultLate = 1U << 6,         ///< ticks were late for longer than the fault age
  kFaultEmergency = 1U << 7,    ///< kLineStop
  kFaultEnable = 1U << 8,       ///< kLineEnableWrong
};

struct DeviceOutput {
  TickOutput tick;           ///< proxy, force, words, supervisor state, status; the force is what the words ask for, before their limits
  Vec3<Mm> hip;              ///< workspace frame; the last known one while the pose is uncertain
  std::uint16_t faults = 0;  ///< Faults
  std::uint8_t packet_flags = 0;  ///< FalconFlags of the next command
  std::uint8_t buttons = 0;       ///< bit 0 to 3 of the newest valid packet

  bool operator==(const DeviceOutput&) const = default;
};

}  // namespace isotouch
