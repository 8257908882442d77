/// The Falcon's run-time packets: 16 bytes each way, every reply answers one command. Pure; bytes that come in pieces are its caller's business.
///
///   byte     0     1-4      5-8        9-12      13                     14       15
///   command  '<'   motor 1  motor 2    motor 3   0x41 + homing, LEDs    0x41     '>'
///   reply    '<'   count 1  count 2    count 3   0x41 + buttons, homed  unknown  '>'
///
/// 1, 2, 3 are top, right, left as a person facing the device sees them. A number is 16 bits as four nibbles, the lowest first, each 0x41 + nibble.
///
/// tick      yes
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "shared/result.h"

namespace isotouch {

inline constexpr std::size_t kFalconPacketBytes = 16;
using FalconPacket = std::array<std::uint8_t, kFalconPacketBytes>;

/// Byte 13 of a command, before 0x41 is added. The colours are those of existing drivers.
enum FalconFlags : std::uint8_t {
  kFalconHoming = 1U << 0,  ///< look for the reference marks
  kFalconGreen = 1U << 1,
  kFalconBlue = 1U << 2,
  kFalconRed = 1U << 3,
};

/// What the host asks for.
struct FalconCommand {
  std::array<std::int16_t, 3> words{};  ///< motor commands; useful within ±4095, a positive one turns the arm inwards
  std::uint8_t flags = 0;               ///< FalconFlags

  bool operator==(const FalconCommand&) const = default;
};

/// What the device answers.
struct FalconReply {
  std::array<std::int16_t, 3> counts{};  ///< rising when the arm swings outwards
  std::uint8_t buttons = 0;              ///< bit 0 right, 1 front, 2 centre, 3 left
  std::uint8_t homed = 0;                ///< bit 0 to 2: leg 1 to 3 has seen its reference

  bool operator==(const FalconReply&) const = default;
};

/// fails     never; of the flags, bits 0 to 3 count
FalconPacket encode(const FalconCommand& command);
/// For simulators and tests. fails never; of the buttons bits 0 to 3 count, of homed bits 0 to 2
FalconPacket encode(const FalconReply& reply);

/// fails     kBadPacket: a first or last byte that is not '<' or '>', a nibble outside 0x41 to 0x50, byte 13 outside 0x41 to 0x50
Result<FalconCommand> decode_command(std::span<const std::uint8_t, kFalconPacketBytes> bytes);
/// fails     kBadPacket: the same, and byte 13 outside 0x41 to 0xC0. A reply that lost bytes on its way fails here
Result<FalconReply> decode_reply(std::span<const std::uint8_t, kFalconPacketBytes> bytes);

}  // namespace isotouch
