#include "host/cloud/lzf.h"

namespace isotouch::cloud {

std::optional<std::vector<std::uint8_t>> unpack_lzf(std::span<const std::uint8_t> packed, std::size_t size) {
  if (size / kLzfMaxGrowth > packed.size()) return std::nullopt;
  std::vector<std::uint8_t> bytes;
  bytes.reserve(size);
  std::size_t at = 0;
  while (at < packed.size()) {
    const std::size_t control = packed[at++];
    if (control < 32) {  // so many bytes as they are, and one
      const std::size_t count = control + 1;
      if (count > packed.size() - at || count > size - bytes.size()) return std::nullopt;
      bytes.insert(bytes.end(), packed.begin() + static_cast<std::ptrdiff_t>(at), packed.begin() + static_cast<std::ptrdiff_t>(at + count));
      at += count;
      continue;
    }
    std::size_t count = (control >> 5) + 2;  // a repetition: its length, and how far back it begins
    if (count == 9) {
      if (at == packed.size()) return std::nullopt;
      count += packed[at++];
    }
    if (at == packed.size()) return std::nullopt;
    const std::size_t back = ((control & 31) << 8) + packed[at++] + 1;
    if (back > bytes.size() || count > size - bytes.size()) return std::nullopt;
    for (; count > 0; --count) bytes.push_back(bytes[bytes.size() - back]);  // byte by byte: it may repeat itself
  }
  if (bytes.size() != size) return std::nullopt;
  return bytes;
}

}  // namespace isotouch::cloud
