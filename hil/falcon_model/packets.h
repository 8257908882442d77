/// The 16 bytes that run each way while the firmware runs: '<', three 16-bit numbers in four nibbles each, two single bytes, '>'.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

namespace isotouch::falcon_model {

inline constexpr std::size_t kPacketBytes = 16;
using PacketBytes = std::array<std::uint8_t, kPacketBytes>;

/// Host to device.
struct CommandPacket {
  std::array<std::int16_t, 3> motors{};  ///< top, right, left
  bool homing = false;
  std::uint8_t leds = 0;  ///< bit 0 green, 1 blue, 2 red
};

/// Device to host.
struct ReplyPacket {
  std::array<std::int16_t, 3> encoders{};  ///< top, right, left
  std::uint8_t buttons = 0;                ///< bit 0 right, 1 forward, 2 centre, 3 left
  std::uint8_t homed = 0;                  ///< bit 0 top, 1 right, 2 left
};

/// Nothing unless the frame is whole: first and last byte, nibbles 'A' to 'P', flags within four bits.
std::optional<CommandPacket> decode_command(std::span<const std::uint8_t, kPacketBytes> bytes);

PacketBytes encode_reply(const ReplyPacket& reply);

/// Finds packets in a stream of bytes: waits for '<', takes 16, and looks again from the next byte when they are none.
class PacketScanner {
 public:
  /// The packet that this byte completes, if it does.
  std::optional<CommandPacket> push(std::uint8_t byte);
  void clear() { count_ = 0; }

 private:
  PacketBytes bytes_{};
  std::size_t count_ = 0;
};

}  // namespace isotouch::falcon_model
