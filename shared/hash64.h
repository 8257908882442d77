/// XXH64 (xxHash's 64-bit variant, https://github.com/Cyan4973/xxHash/blob/dev/doc/xxhash_spec.md): the hash of images and of the trace's chain.
/// Any `xxhsum -H1` gives the same digits for a file.
///
/// tick      yes for the fixed size of a record
#pragma once

#include <cstddef>
#include <cstdint>

#include "shared/bytes.h"

namespace isotouch {

namespace hash64_detail {
inline constexpr std::uint64_t kPrime1 = 0x9E3779B185EBCA87ULL;
inline constexpr std::uint64_t kPrime2 = 0xC2B2AE3D27D4EB4FULL;
inline constexpr std::uint64_t kPrime3 = 0x165667B19E3779F9ULL;
inline constexpr std::uint64_t kPrime4 = 0x85EBCA77C2B2AE63ULL;
inline constexpr std::uint64_t kPrime5 = 0x27D4EB2F165667C5ULL;
constexpr std::uint64_t rotate(std::uint64_t v, int by) { return (v << by) | (v >> (64 - by)); }
constexpr std::uint64_t round(std::uint64_t lane, std::uint64_t input) { return rotate(lane + input * kPrime2, 31) * kPrime1; }
constexpr std::uint64_t merge(std::uint64_t hash, std::uint64_t lane) { return (hash ^ round(0, lane)) * kPrime1 + kPrime4; }
}  // namespace hash64_detail

/// The hash of `size` bytes; the seed chains one hash into the next.
constexpr std::uint64_t hash64(const std::uint8_t* data, std::size_t size, std::uint64_t seed = 0) {
  using namespace hash64_detail;
  const std::uint8_t* at = data;
  std::size_t left = size;
  std::uint64_t hash = seed + kPrime5;
  if (size >= 32) {
    std::uint64_t lane[4] = {seed + kPrime1 + kPrime2, seed + kPrime2, seed, seed - kPrime1};
    for (; left >= 32; left -= 32, at += 32) {
      for (std::size_t i = 0; i < 4; ++i) lane[i] = round(lane[i], load_le<std::uint64_t>(at + 8 * i));
    }
    hash = rotate(lane[0], 1) + rotate(lane[1], 7) + rotate(lane[2], 12) + rotate(lane[3], 18);
    for (const std::uint64_t l : lane) hash = merge(hash, l);
  }
  hash += size;
  for (; left >= 8; left -= 8, at += 8) hash = rotate(hash ^ round(0, load_le<std::uint64_t>(at)), 27) * kPrime1 + kPrime4;
  if (left >= 4) {
    hash = rotate(hash ^ (load_le<std::uint32_t>(at) * kPrime1), 23) * kPrime2 + kPrime3;
    left -= 4;
    at += 4;
  }
  for (; left > 0; --left, ++at) hash = rotate(hash ^ (*at * kPrime5), 11) * kPrime1;
  hash = (hash ^ (hash >> 33)) * kPrime2;
  hash = (hash ^ (hash >> 29)) * kPrime3;
  return hash ^ (hash >> 32);
}

}  // namespace isotouch
