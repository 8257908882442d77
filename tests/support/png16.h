/// Small PNG files of any pixel format, not compressed: what a test of a reader needs.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>

namespace isotouch::test {

inline std::string big_endian(std::uint32_t value) {
  std::string bytes;
  for (int shift = 24; shift >= 0; shift -= 8) bytes += static_cast<char>(value >> shift & 0xff);
  return bytes;
}

inline std::uint32_t png_crc(std::string_view bytes) {
  std::uint32_t crc = 0xffffffff;
  for (const char c : bytes) {
    crc ^= static_cast<std::uint8_t>(c);
    for (int bit = 0; bit < 8; ++bit) crc = (crc & 1) != 0 ? 0xedb88320 ^ crc >> 1 : crc >> 1;
  }
  return ~crc;
}

inline std::string png_chunk(const std::string& kind, const std::string& body) {
  return big_endian(static_cast<std::uint32_t>(body.size())) + kind + body + big_endian(png_crc(kind + body));
}

/// rows      of the image from the top, each with the bytes of its pixels; 16-bit numbers big-endian
/// colour    0 grey, 2 red, green and blue
inline std::string png(std::uint32_t width, std::uint32_t height, const std::string& rows, int bits = 16, int colour = 0,
                       const std::string& chunks = "") {
  const std::size_t row_bytes = height == 0 ? 0 : rows.size() / height;
  std::string filtered;
  for (std::uint32_t row = 0; row < height; ++row) filtered += '\0' + rows.substr(row * row_bytes, row_bytes);
  std::uint32_t a = 1, b = 0;  // Adler-32
  for (const char c : filtered) {
    a = (a + static_cast<std::uint8_t>(c)) % 65521;
    b = (b + a) % 65521;
  }
  std::string stream = "\x78\x01";
  for (std::size_t at = 0; at < filtered.size() || at == 0; at += 65535) {
    const std::string block = filtered.substr(at, 65535);
    const std::size_t size = block.size();
    stream += at + 65535 >= filtered.size() ? '\1' : '\0';
    for (const std::size_t value : {size, ~size}) stream += {static_cast<char>(value & 0xff), static_cast<char>(value >> 8 & 0xff)};
    stream += block;
  }
  stream += big_endian(b << 16 | a);
  const std::string header =
      big_endian(width) + big_endian(height) + static_cast<char>(bits) + static_cast<char>(colour) + std::string(3, '\0');
  return "\x89PNG\r\n\x1a\n" + png_chunk("IHDR", header) + chunks + png_chunk("IDAT", stream) + png_chunk("IEND", "");
}

}  // namespace isotouch::test
