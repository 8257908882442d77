#include "shared/zstd_frame.h"

#include <array>
#include <cstddef>

namespace isotouch {

namespace {

/// Takes numbers off the front; 0 and not good where there are too few bytes.
struct Front {
  std::span<const std::uint8_t> rest;
  bool good = true;

  std::uint64_t take(std::size_t bytes) {
    std::uint64_t value = 0;
    for (std::size_t i = 0; i < bytes && i < rest.size(); ++i) value |= std::uint64_t{rest[i]} << (8 * i);
    skip(bytes);
    return value;
  }
  void skip(std::uint64_t bytes) {
    good &= bytes <= rest.size();
    rest = good ? rest.subspan(static_cast<std::size_t>(bytes)) : rest.first(0);
  }
};

constexpr std::uint64_t kMagic = 0xFD2FB528;

}  // namespace

std::optional<ZstdFrame> read_zstd_frame(std::span<const std::uint8_t> bytes) {
  Front front{bytes};
  if (front.take(4) != kMagic) return std::nullopt;
  const std::uint64_t descriptor = front.take(1);
  const bool single_segment = (descriptor & 0x20U) != 0, has_checksum = (descriptor & 4U) != 0, reserved = (descriptor & 8U) != 0;
  if (reserved) return std::nullopt;

  ZstdFrame frame;
  if (!single_segment) {
    const std::uint64_t window = front.take(1);
    const std::uint64_t base = std::uint64_t{1} << (10 + (window >> 3));
    frame.window_bytes = base + base / 8 * (window & 7U);
  }
  frame.dictionary = static_cast<std::uint32_t>(front.take(std::array<std::size_t, 4>{0, 1, 2, 4}[descriptor & 3U]));
  switch (descriptor >> 6) {
    case 0:
      if (!single_segment) return std::nullopt;  // the content size is not stated
      frame.content_bytes = front.take(1);
      break;
    case 1: frame.content_bytes = front.take(2) + 256; break;
    case 2: frame.content_bytes = front.take(4); break;
    default: frame.content_bytes = front.take(8); break;
  }
  if (single_segment) frame.window_bytes = frame.content_bytes;

  for (bool last = false; !last;) {
    const std::uint64_t block = front.take(3);
    const std::uint64_t type = block >> 1 & 3U, size = block >> 3;
    if (!front.good || type == 3) return std::nullopt;
    front.skip(type == 1 ? 1 : size);  // type 1 repeats one byte
    last = (block & 1U) != 0;
  }
  if (has_checksum) front.skip(4);
  if (!front.good || !front.rest.empty()) return std::nullopt;
  return frame;
}

}  // namespace isotouch
