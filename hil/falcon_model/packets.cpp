#include "hil/falcon_model/packets.h"

#include <algorithm>

namespace isotouch::falcon_model {

namespace {

constexpr std::uint8_t kBegin = '<', kEnd = '>', kZero = 'A';
constexpr std::size_t kFlags = 13;

/// The 16-bit number whose nibbles, least significant first, begin at `at`.
std::int16_t number_at(std::span<const std::uint8_t, kPacketBytes> bytes, std::size_t at) {
  unsigned value = 0;
  for (unsigned k = 0; k < 4; ++k) value |= static_cast<unsigned>(bytes[at + k] - kZero) << 4 * k;
  return static_cast<std::int16_t>(value);
}

}  // namespace

std::optional<CommandPacket> decode_command(std::span<const std::uint8_t, kPacketBytes> bytes) {
  if (bytes.front() != kBegin || bytes.back() != kEnd) return std::nullopt;
  if (std::any_of(bytes.begin() + 1, bytes.end() - 1, [](std::uint8_t b) { return b < kZero || b > kZero + 15; })) return std::nullopt;
  const unsigned flags = static_cast<unsigned>(bytes[kFlags] - kZero);
  return CommandPacket{
      {number_at(bytes, 1), number_at(bytes, 5), number_at(bytes, 9)}, (flags & 1) != 0, static_cast<std::uint8_t>(flags >> 1)};
}

PacketBytes encode_reply(const ReplyPacket& reply) {
  PacketBytes bytes{};
  bytes.front() = kBegin;
  for (std::size_t i = 0; i < 3; ++i) {
    const unsigned value = static_cast<std::uint16_t>(reply.encoders[i]);
    for (unsigned k = 0; k < 4; ++k) bytes[1 + 4 * i + k] = static_cast<std::uint8_t>(kZero + (value >> 4 * k & 15));
  }
  bytes[kFlags] = static_cast<std::uint8_t>(kZero + (reply.buttons & 15) + 16 * (reply.homed & 7));
  bytes[kFlags + 1] = kZero;
  bytes.back() = kEnd;
  return bytes;
}

std::optional<CommandPacket> PacketScanner::push(std::uint8_t byte) {
  bytes_[count_++] = byte;
  const auto look = [&](std::size_t from) {  // keeps what begins with the next '<'
    const auto begin =
        std::find(bytes_.begin() + static_cast<std::ptrdiff_t>(from), bytes_.begin() + static_cast<std::ptrdiff_t>(count_), kBegin);
    count_ =
        static_cast<std::size_t>(std::move(begin, bytes_.begin() + static_cast<std::ptrdiff_t>(count_), bytes_.begin()) - bytes_.begin());
  };
  look(0);
  if (count_ < kPacketBytes) return std::nullopt;
  const auto packet = decode_command(bytes_);
  if (packet) {
    count_ = 0;
  } else {
    look(1);
  }
  return packet;
}

}  // namespace isotouch::falcon_model
