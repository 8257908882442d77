/// The two sides of a device. The tick sees a `Device`: the newest reply, and a place to leave commands. Who really talks to hardware is a `Port`, which
/// blocks; `exchange_thread.h` joins them by a thread of its own, `direct_device.h` without one.
#pragma once

#include <cstdint>
#include <limits>

#include "shared/falcon_packet.h"
#include "shared/tick_io.h"

namespace isotouch::loop {

/// No limit of time.
inline constexpr std::int64_t kNever = std::numeric_limits<std::int64_t>::max();

/// The newest reply of the device. Times are those of a Clock.
struct Sample {
  FalconPacket packet{};        ///< as it came; all zero before the first
  std::uint64_t number = 0;     ///< counts replies from 1; 0 = none yet. The same number = the same sample
  std::int64_t sent_ns = 0;     ///< when the command that it answers was handed to the link
  std::int64_t arrival_ns = 0;  ///< when it was there
  std::int64_t word_delay_ns =
      -1;  ///< from the previous sample's arrival to the hand-over of the first command computed from it; -1 = not known
};

/// What the tick asks of the device.
struct Command {
  FalconCommand falcon;
  std::uint64_t tick = 0;              ///< number of the tick that made it, from 1; 0 = none yet
  std::uint64_t sample = 0;            ///< number of the sample that the command was computed from
  std::int64_t arrival_ns = -1;        ///< when that sample arrived
  std::uint32_t field_generation = 0;  ///< of the field that it was computed with, 0 = none
};

/// Why a wait ended.
enum class Wake : std::uint8_t {
  kReply,  ///< there is a sample that `newest` has not returned yet
  kDue,    ///< none came
  kEnd,    ///< none will come any more
};

/// The tick's side.
class Device {
 public:
  virtual ~Device() = default;

  /// Waits for a reply, at the latest until `until_ns`.
  ///
  /// tick      yes: the one blocking call beside the clock's
  virtual Wake wait(std::int64_t until_ns) = 0;

  /// tick      yes
  virtual Sample newest() = 0;

  /// Leaves a command; an older one that was not sent yet is forgotten.
  ///
  /// tick      yes
  virtual void leave(const Command& command) = 0;
};

/// The outcome of one exchange of a port.
enum class Answer : std::uint8_t {
  kReply,   ///< the device answered
  kSilent,  ///< it was asked and did not answer
  kAbsent,  ///< there is no device to ask: it is being searched for or started
  kEnd,     ///< there will be no more, for good: a recording is over
};

/// Stands between the tick's commands and the port, on the port's side, and may only take force away. Called by the thread that talks to the device; in
/// lockstep by the tick's.
class CommandGuard {
 public:
  virtual ~CommandGuard() = default;

  /// now_ns    as it is handed to the port
  /// returns   the motor commands that may go on: those of the command, or none
  /// fails     never. Does not allocate; may make a system call that does not wait
  virtual MotorCommands pass(const Command& command, std::int64_t now_ns) = 0;

  /// The port answered with this packet. Called before the next `pass`, on the same thread and with the same limits.
  virtual void hear(const FalconPacket& packet, std::int64_t now_ns) = 0;
};

/// The hardware's side, used by one thread.
class Port {
 public:
  virtual ~Port() = default;

  /// Sends one command and waits for its reply; or does a piece of the work that leads to a device that answers.
  ///
  /// reply     changed by kReply only
  /// fails     never; waits for at most about 10 ms while a device runs, up to seconds while it is brought up
  virtual Answer exchange(const FalconCommand& command, FalconPacket& reply) = 0;

  /// Takes the forces away at once, and for good. Called on every way out of the program.
  virtual void rest() = 0;
};

}  // namespace isotouch::loop
