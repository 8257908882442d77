#include "shared/falcon_packet.h"

namespace isotouch {

namespace {

constexpr std::uint8_t kBegin = '<';
constexpr std::uint8_t kEnd = '>';
constexpr std::uint8_t kZero = 0x41;  // 'A'
constexpr std::size_t kFlagsAt = 13;
constexpr std::uint8_t kMaxCommandFlags = 0x0F;
constexpr std::uint8_t kMaxReplyFlags = 0x7F;

FalconPacket frame(const std::array<std::int16_t, 3>& numbers, unsigned flags) {
  FalconPacket packet{};
  packet.front() = kBegin;
  for (std::size_t n = 0; n < numbers.size(); ++n) {
    const auto bits = static_cast<std::uint16_t>(numbers[n]);
    for (std::size_t nibble = 0; nibble < 4; ++nibble) {
      packet[1 + 4 * n + nibble] = static_cast<std::uint8_t>(kZero + ((bits >> (4 * nibble)) & 0x0F));
    }
  }
  packet[kFlagsAt] = static_cast<std::uint8_t>(kZero + flags);
  packet[14] = kZero;
  packet.back() = kEnd;
  return packet;
}

/// Every byte of a packet stands where it may: `most` is the largest value of byte 13 above 0x41.
bool is_well_formed(std::span<const std::uint8_t, kFalconPacketBytes> bytes, std::uint8_t most) {
  const auto within = [&](std::size_t at, std::uint8_t largest) { return bytes[at] >= kZero && bytes[at] - kZero <= largest; };
  bool good = bytes[0] == kBegin && bytes[15] == kEnd && within(kFlagsAt, most) && within(14, 0x0F);
  for (std::size_t at = 1; at < kFlagsAt; ++at) good &= within(at, 0x0F);
  return good;
}

std::array<std::int16_t, 3> numbers_of(std::span<const std::uint8_t, kFalconPacketBytes> bytes) {
  std::array<std::int16_t, 3> numbers{};
  for (std::size_t n = 0; n < numbers.size(); ++n) {
    unsigned bits = 0;
    for (std::size_t nibble = 0; nibble < 4; ++nibble) bits |= static_cast<unsigned>(bytes[1 + 4 * n + nibble] - kZero) << (4 * nibble);
    numbers[n] = static_cast<std::int16_t>(bits);
  }
  return numbers;
}

}  // namespace

FalconPacket encode(const FalconCommand& command) { return frame(command.words, command.flags & kMaxCommandFlags); }

FalconPacket encode(const FalconReply& reply) { return frame(reply.counts, (reply.buttons & 0x0FU) | ((reply.homed & 0x07U) << 4)); }

Result<FalconCommand> decode_command(std::span<const std::uint8_t, kFalconPacketBytes> bytes) {
  if (!is_well_formed(bytes, kMaxCommandFlags)) return Error::kBadPacket;
  return FalconCommand{numbers_of(bytes), static_cast<std::uint8_t>(bytes[kFlagsAt] - kZero)};
}

Result<FalconReply> decode_reply(std::span<const std::uint8_t, kFalconPacketBytes> bytes) {
  if (!is_well_formed(bytes, kMaxReplyFlags)) return Error::kBadPacket;
  const unsigned flags = bytes[kFlagsAt] - static_cast<unsigned>(kZero);
  return FalconReply{numbers_of(bytes), static_cast<std::uint8_t>(flags & 0x0F), static_cast<std::uint8_t>(flags >> 4)};
}

}  // namespace isotouch
