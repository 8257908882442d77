/// Judges the tick's motor commands before they reach the device. It relies on the device's packets, the field, the safety lines, the requests and the
/// largest settings. It knows neither what the tick felt nor what the supervisor decided. It can only take force away.
///
/// What a command must not be, in the order in which it is looked for (`GuardVerdict`):
///
/// - beyond the limit of the motors;
/// - other than zero while a safety line is bad, after a stop, or while the light shows no force;
/// - other than zero after packets that forbid it: no reference, counts that jumped, none that came, no button held, too fast a hand, no place that the
///   arms reach;
/// - more than the motors can bear for long;
/// - other than zero while an encoder is stuck, see `encoder_watch.h`;
/// - without contact, stronger than the way of the hand in contact explains, or into the object;
/// - the same again and again while the hand moves.
///
/// The hand's way bounds the spring: in contact the proxy only ever comes nearer to the HIP, so the distance between both grows by the HIP's movement
/// at most. A surface that moves by itself adds what it may rise by, as gently as the force may follow it; where out is, is then not known any more. Energy
/// is no bound here: force that returns by a ramp pushes a hand that went in while there was none, and so gives what it never took.
#pragma once

#include <array>
#include <cstdint>

#include "firmware/guard/arm_geometry.h"
#include "firmware/guard/encoder_watch.h"
#include "firmware/loop/device.h"
#include "shared/device_model.h"
#include "shared/field_view.h"
#include "shared/tick_io.h"
#include "shared/tick_settings.h"

namespace isotouch::guard {

/// What the guard remembers; a default one knows of no packet.
struct Memory {
  // Of the packets.
  std::uint64_t replies = 0;       ///< that came, malformed ones included: the number of the newest sample
  std::int64_t heard_ns = 0;       ///< when the newest valid one came; 0 = none yet
  std::uint64_t heard_tick = 0;    ///< of the newest command when it came
  std::uint64_t valid = 0;         ///< its number
  std::uint64_t valid_before = 0;  ///< that of the valid one before: a command may be on its way while the newest comes
  std::uint64_t fresh = 0;         ///< number of the newest valid one that a command was computed from, and the tick that did it first
  std::uint64_t fresh_tick = 0;
  std::array<std::int16_t, 3> counts{};
  std::uint32_t referenced_in_a_row = 0;
  bool referenced = false;
  bool has_grip = false;
  Grip grip;                      ///< newest place of the hand
  double step = 0;                ///< mm, of the newest packet
  std::array<Point, 4> places{};  ///< mm, of the newest four packets: number % 4
  std::array<double, 4> took{};   ///< s, from packet to packet, by the same places
  double fastest = 0;             ///< mm/s, decays within some 50 packets
  /// Numbers of the samples since which a command must be zero; 0: it need not.
  struct {
    std::uint64_t reference, jump, button, speed, pose, free;
  } since{};

  EncoderMemory encoders;

  // Of the contact.
  std::uint64_t placed = 0;            ///< the newest sample that was compared with the field
  std::uint32_t field_generation = 0;  ///< of the field that it was compared with
  bool near = false;                   ///< there may be contact
  Point began{};                       ///< the last HIP that was surely outside, or the first that was near
  Point last{};                        ///< the HIP when its way was last added to
  double way = 0;                      ///< mm, of the HIP since then
  std::uint32_t surface = 0;           ///< of that field
  bool outside = false;                ///< it began surely outside, so a true force points back there
  bool moved = false;                  ///< the surface has moved by itself since there may be contact
  double risen = 0, may_rise = 0;      ///< N, by which the spring may be stronger for that: now, and when the force has followed

  // Of the commands.
  std::uint64_t tick = 0;            ///< of the newest command
  MotorCommands commands{};          ///< that were sent last
  std::int64_t sent_ns = 0;          ///< when
  std::uint64_t repeated_since = 0;  ///< the tick that made the first of those that were the same
  Grip repeated_at;
  std::array<double, 3> heat{};    ///< mean squares
  std::uint32_t stops = 0;         ///< that were asked for
  std::uint64_t stop_tick = 0;     ///< of the first command after a stop that nobody has resumed from; 0 = there was none
  bool knows_buttons = false;      ///< enough packets have come for it
  std::uint8_t buttons = 0;        ///< as the hand holds them: what a few valid packets in a row showed
  std::uint8_t may_hold = 0;       ///< those that the tick may take for held: it forgets them later
  std::uint8_t shown = 0;          ///< by the newest valid packet
  std::uint32_t steady = 0;        ///< valid packets in a row that show the same of the model's buttons
  std::uint32_t steady_ticks = 0;  ///< ticks in which they came
  std::uint64_t lines_tick = 0;    ///< of the first command beside lines that are not good; 0 = they are good

  // Of its own verdict.
  GuardVerdict verdict = GuardVerdict::kNone;
  std::uint64_t verdict_tick = 0;  ///< whose command it was
  std::int64_t quiet_ns = 0;       ///< since when the tick has asked for nothing

  LiveRaw largest{};  ///< of every setting since the start
};

/// What a command is judged by.
struct Evidence {
  std::int64_t now_ns = 0;
  std::uint8_t lines = 0;            ///< LineBits, as the watchdog has them now
  std::uint32_t stops = 0;           ///< that were asked for since the start
  bool stopped = false;              ///< no resume was asked for since
  const FieldView* field = nullptr;  ///< of the generation that the command names; nullptr: there is none, or it is not known
  std::uint32_t surface = 0;         ///< the same number as of another generation: the same surface, which has moved; 0 = not known
  TickSettings largest;              ///< of every setting the largest since the start
};

class Guard {
 public:
  Guard(const DeviceModel& device, std::uint32_t period_ns);

  /// A command on its way to the device.
  ///
  /// returns   the motor commands that may go on: those asked for, or none
  /// fails     never
  MotorCommands judge(const loop::Command& command, const Evidence& evidence, Memory& memory) const;

  /// What came back.
  ///
  /// now_ns    when
  void hear(const FalconPacket& packet, std::int64_t now_ns, Memory& memory) const;

 private:
  void note(const loop::Command& command, const Evidence& evidence, Memory& memory) const;
  GuardVerdict contradiction(const loop::Command& command, const Evidence& evidence, const Memory& memory) const;
  GuardVerdict of_contact(const loop::Command& command, const Evidence& evidence, const Memory& memory) const;
  bool is_felt(const Point& force, const Evidence& evidence, const Memory& memory) const;
  void place(const loop::Command& command, const Evidence& evidence, Memory& memory) const;
  void follow_buttons(std::uint8_t shown, std::int64_t now_ns, Memory& memory) const;
  void find_hand(const FalconReply& reply, double took_s, bool leapt, Memory& memory) const;
  void warm(std::int64_t now_ns, Memory& memory) const;
  bool is_too_hot(const Memory& memory) const;

  DeviceModel device_;
  ArmGeometry arms_;
  std::uint32_t period_ns_;
};

}  // namespace isotouch::guard
