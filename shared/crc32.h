/// CRC-32 of IEEE 802.3 (polynomial 0xEDB88320 reflected, as zlib and PNG): the blob's checksum.
///
/// tick      no: its time grows with the data
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace isotouch {

namespace crc32_detail {
consteval std::array<std::uint32_t, 256> table() {
  std::array<std::uint32_t, 256> entries{};
  for (std::uint32_t i = 0; i < 256; ++i) {
    std::uint32_t value = i;
    for (int bit = 0; bit < 8; ++bit) value = (value >> 1) ^ ((value & 1U) != 0 ? 0xEDB88320U : 0U);
    entries[i] = value;
  }
  return entries;
}
inline constexpr std::array<std::uint32_t, 256> kTable = table();
}  // namespace crc32_detail

/// The checksum of `size` bytes; `previous` continues a checksum over data in pieces. "123456789" gives 0xCBF43926.
constexpr std::uint32_t crc32(const std::uint8_t* data, std::size_t size, std::uint32_t previous = 0) {
  std::uint32_t state = ~previous;
  for (std::size_t i = 0; i < size; ++i) state = (state >> 8) ^ crc32_detail::kTable[(state ^ data[i]) & 0xFFU];
  return ~state;
}

}  // namespace isotouch
