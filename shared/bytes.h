/// Little-endian integers in byte arrays, independent of the processor's own order and alignment.
///
/// tick      yes
#pragma once

#include <cstddef>
#include <cstdint>
#include <type_traits>

namespace isotouch {

template <class T>
constexpr T load_le(const std::uint8_t* at) {
  using U = std::make_unsigned_t<T>;
  std::uint64_t value = 0;
  for (std::size_t i = 0; i < sizeof(T); ++i) value |= std::uint64_t{at[i]} << (8 * i);
  return static_cast<T>(static_cast<U>(value));
}

template <class T>
constexpr void store_le(std::uint8_t* at, T value) {
  const auto bits = static_cast<std::uint64_t>(static_cast<std::make_unsigned_t<T>>(value));
  for (std::size_t i = 0; i < sizeof(T); ++i) at[i] = static_cast<std::uint8_t>(bits >> (8 * i));
}

}  // namespace isotouch
