/// LZF, the compression of binary PCD files.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace isotouch::cloud {

/// No more than this many bytes can come out of one: three bytes repeat up to 264.
inline constexpr std::size_t kLzfMaxGrowth = 88;

/// size      of what was packed
/// returns   exactly that many bytes; nothing when the packed bytes end early, repeat what is not there, or hold more or less
/// source    the format of LibLZF 3.6, M. Lehmann
std::optional<std::vector<std::uint8_t>> unpack_lzf(std::span<const std::uint8_t> packed, std::size_t size);

}  // namespace isotouch::cloud
