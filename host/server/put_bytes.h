/// Little-endian numbers at the end of a text: what the page is sent in binary.
#pragma once

#include <bit>
#include <concepts>
#include <cstdint>
#include <string>

#include "shared/bytes.h"

namespace isotouch::server {

template <std::integral T>
void put_whole(std::string& bytes, T value) {
  std::uint8_t raw[sizeof(T)];
  store_le(raw, value);
  bytes.append(reinterpret_cast<const char*>(raw), sizeof raw);
}

inline void put_float(std::string& bytes, double value) { put_whole(bytes, std::bit_cast<std::uint32_t>(static_cast<float>(value))); }

}  // namespace isotouch::server
