/// The outline of a zstd frame (RFC 8878, 3.1.1), read without the library: what it will take to unpack, before anything is unpacked.
///
/// tick      no: its time grows with the frame
#pragma once

#include <cstdint>
#include <optional>
#include <span>

namespace isotouch {

struct ZstdFrame {
  std::uint64_t content_bytes = 0;
  std::uint64_t window_bytes = 0;
  std::uint32_t dictionary = 0;  ///< 0 = none
};

/// returns   nothing when the bytes are not exactly one frame that states its content size
std::optional<ZstdFrame> read_zstd_frame(std::span<const std::uint8_t> bytes);

}  // namespace isotouch
