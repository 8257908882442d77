/// CRC-32 of IEEE 802.3 (polynomial 0xEDB88320 reflected, as zlib and PNG): the field's checksum.
///
/// tick      no: its time grows with the data
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "shared/bytes.h"

namespace isotouch {

namespace crc32_detail {
/// tables[k][b]: what byte b, followed by k zero bytes, does to the checksum.
consteval std::array<std::array<std::uint32_t, 256>, 16> make_tables() {
  std::array<std::array<std::uint32_t, 256>, 16> tables{};
  for (std::uint32_t i = 0; i < 256; ++i) {
    std::uint32_t value = i;
    for (int bit = 0; bit < 8; ++bit) value = (value >> 1) ^ ((value & 1U) != 0 ? 0xEDB88320U : 0U);
    tables[0][i] = value;
  }
  for (std::size_t k = 1; k < tables.size(); ++k) {
    for (std::size_t i = 0; i < 256; ++i) tables[k][i] = (tables[k - 1][i] >> 8) ^ tables[0][tables[k - 1][i] & 0xFFU];
  }
  return tables;
}
inline constexpr auto kTables = make_tables();

/// What four bytes, followed by `zeros` zero bytes, do to the checksum.
constexpr std::uint32_t four(std::uint32_t bytes, std::size_t zeros) {
  return kTables[zeros + 3][bytes & 0xFFU] ^ kTables[zeros + 2][bytes >> 8 & 0xFFU] ^ kTables[zeros + 1][bytes >> 16 & 0xFFU] ^
         kTables[zeros][bytes >> 24];
}
}  // namespace crc32_detail

/// The checksum of `size` bytes; `previous` continues a checksum over data in pieces. "123456789" gives 0xCBF43926.
///
/// source    sixteen bytes a step, after Kounavis and Berry, Novel table lookup-based algorithms for high-performance CRC generation, 2008
constexpr std::uint32_t crc32(const std::uint8_t* data, std::size_t size, std::uint32_t previous = 0) {
  using crc32_detail::four;
  const auto word = [](const std::uint8_t* at) { return load_le<std::uint32_t>(at); };
  std::uint32_t state = ~previous;
  for (; size >= 16; data += 16, size -= 16) {
    state = four(word(data) ^ state, 12) ^ four(word(data + 4), 8) ^ four(word(data + 8), 4) ^ four(word(data + 12), 0);
  }
  for (std::size_t i = 0; i < size; ++i) state = (state >> 8) ^ crc32_detail::kTables[0][(state ^ data[i]) & 0xFFU];
  return ~state;
}

}  // namespace isotouch
