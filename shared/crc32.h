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
consteval std::array<std::array<std::uint32_t, 256>, 8> make_tables() {
  std::array<std::array<std::uint32_t, 256>, 8> tables{};
  for (std::uint32_t i = 0; i < 256; ++i) {
    std::uint32_t value = i;
    for (int bit = 0; bit < 8; ++bit) value = (value >> 1) ^ ((value & 1U) != 0 ? 0xEDB88320U : 0U);
    tables[0][i] = value;
  }
  for (std::size_t k = 1; k < 8; ++k) {
    for (std::size_t i = 0; i < 256; ++i) tables[k][i] = (tables[k - 1][i] >> 8) ^ tables[0][tables[k - 1][i] & 0xFFU];
  }
  return tables;
}
inline constexpr auto kTables = make_tables();
}  // namespace crc32_detail

/// The checksum of `size` bytes; `previous` continues a checksum over data in pieces. "123456789" gives 0xCBF43926.
///
/// source    eight bytes a step: Kounavis and Berry, Novel table lookup-based algorithms for high-performance CRC generation, 2008
constexpr std::uint32_t crc32(const std::uint8_t* data, std::size_t size, std::uint32_t previous = 0) {
  const auto& tables = crc32_detail::kTables;
  std::uint32_t state = ~previous;
  for (; size >= 8; data += 8, size -= 8) {
    const std::uint32_t first = state ^ load_le<std::uint32_t>(data), second = load_le<std::uint32_t>(data + 4);
    state = tables[7][first & 0xFFU] ^ tables[6][first >> 8 & 0xFFU] ^ tables[5][first >> 16 & 0xFFU] ^ tables[4][first >> 24] ^
            tables[3][second & 0xFFU] ^ tables[2][second >> 8 & 0xFFU] ^ tables[1][second >> 16 & 0xFFU] ^ tables[0][second >> 24];
  }
  for (std::size_t i = 0; i < size; ++i) state = (state >> 8) ^ tables[0][(state ^ data[i]) & 0xFFU];
  return ~state;
}

}  // namespace isotouch
