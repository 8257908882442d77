/// What runs on the board once it is loaded: one reply for each packet, homing, lights, and torques that must be refreshed.
#pragma once

#include <array>

#include "hil/falcon_model/mechanism.h"
#include "hil/falcon_model/packets.h"
#include "hil/falcon_model/quirks.h"

namespace isotouch::falcon_model {

class Firmware {
 public:
  /// hold_packets   a torque is kept for so many packets' time without a new one
  Firmware(const Quirks& quirks, int hold_packets) : quirks_(quirks), hold_packets_(hold_packets) {}

  /// Starts anew: every axis counts from where it stands and is not homed.
  void start(const Counts& now);

  /// Takes one packet. `now` are the true counts at its receipt, which the reply carries from each axis's own zero.
  ReplyPacket take(const CommandPacket& packet, const Counts& now, std::uint8_t buttons);

  /// A packet's time went by without a packet.
  void miss(int packets = 1);

  /// The motors' commands, zero when the last packet is too long ago.
  Commands commands() const;
  std::uint8_t leds() const { return leds_; }
  std::uint8_t homed() const { return homed_; }
  /// How often a torque ended because no packet renewed it.
  int expired() const { return expired_; }

  /// Every axis counts from where it stands, as after a start.
  void lose_homing(const Counts& now);
  /// One axis counts so many more from now on.
  void jump(std::size_t axis, int counts) { zero_[axis] -= counts; }
  /// The axes of the mask report from now on what they would report now; 0: every axis moves again.
  void stick(std::uint8_t mask, const Counts& now) {
    stuck_ = mask;
    stuck_at_ = now;
  }

 private:
  Quirks quirks_;
  int hold_packets_;
  Counts zero_{};
  Counts last_{};
  Counts stuck_at_{};
  std::uint8_t stuck_ = 0;
  std::uint8_t homed_ = 0;
  std::uint8_t leds_ = 0;
  Commands commands_{};
  int age_ = 0;  ///< packets' times since the commands came
  int expired_ = 0;
};

}  // namespace isotouch::falcon_model
