#include "hil/falcon_model/firmware.h"

#include <algorithm>

namespace isotouch::falcon_model {

void Firmware::start(const Counts& now) {
  lose_homing(now);
  leds_ = 0;
  commands_ = {};
}

void Firmware::lose_homing(const Counts& now) {
  zero_ = last_ = now;
  homed_ = 0;
}

ReplyPacket Firmware::take(const CommandPacket& packet, const Counts& true_counts, std::uint8_t buttons) {
  ReplyPacket reply;
  Counts now = true_counts;
  for (std::size_t i = 0; i < kLegs; ++i) {
    if ((stuck_ >> i & 1U) != 0) now[i] = stuck_at_[i];
  }
  for (std::size_t i = 0; i < kLegs; ++i) {
    const auto bit = static_cast<std::uint8_t>(1U << i);
    const bool passed_reference = (last_[i] < 0) != (now[i] < 0);
    if (packet.homing && (homed_ & bit) == 0 && passed_reference) {
      homed_ |= bit;
      zero_[i] = 0;
    }
    const bool frozen = quirks_.frozen_until_homed && (homed_ & bit) == 0;
    reply.encoders[i] = static_cast<std::int16_t>(frozen ? 0 : now[i] - zero_[i]);
    commands_[i] = packet.motors[i];
  }
  last_ = now;
  reply.buttons = buttons;
  reply.homed = quirks_.homed_only_while_homing && !packet.homing ? std::uint8_t{0} : homed_;
  leds_ = packet.leds;
  age_ = 0;
  return reply;
}

void Firmware::miss(int packets) {
  const bool felt = commands() != Commands{};
  age_ = std::min(age_ + std::min(packets, hold_packets_), hold_packets_);
  if (felt && commands() == Commands{}) ++expired_;
}

Commands Firmware::commands() const { return age_ < hold_packets_ ? commands_ : Commands{}; }

}  // namespace isotouch::falcon_model
