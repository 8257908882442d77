/// The records of an MCAP file: their numbers, and how numbers and strings stand in them.
///
/// source    MCAP format specification, version 0, mcap.dev/spec
#pragma once

#include <array>
#include <cstdint>

namespace isotouch::bag {

inline constexpr std::array<std::uint8_t, 8> kMcapMagic = {0x89, 'M', 'C', 'A', 'P', '0', '\r', '\n'};

enum class Record : std::uint8_t {
  kHeader = 0x01,
  kFooter = 0x02,
  kSchema = 0x03,
  kChannel = 0x04,
  kMessage = 0x05,
  kChunk = 0x06,
  kMessageIndex = 0x07,
  kChunkIndex = 0x08,
  kAttachment = 0x09,
  kAttachmentIndex = 0x0A,
  kStatistics = 0x0B,
  kSummaryOffset = 0x0E,
  kDataEnd = 0x0F,
};

/// An opcode and a length stand before the content of each record.
inline constexpr std::uint64_t kRecordHead = 9;

}  // namespace isotouch::bag
