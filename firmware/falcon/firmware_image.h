/// The container of a Falcon firmware: what the boot ROM of its DSP reads. Images belong to the device's maker and are not part of this program.
///
///   AA 08             key: an 8-bit stream
///   00 × 16           reserved
///   entry             4 bytes
///   blocks            { words, 2 bytes; destination, 4 bytes; 2 × words bytes }, the last one with words = 0 and nothing behind its count
///
/// 16-bit words are little-endian; the two halves of a 32-bit number come high half first.
///
/// source    TI SPRU095, boot ROM of the TMS320C281x
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "shared/files/refusal.h"

namespace isotouch::falcon {

enum class ImageDefect : std::uint8_t {
  kNone,
  kTooShort,     ///< ends within the header
  kWrongKey,     ///< does not begin with AA 08
  kReserved,     ///< a reserved byte is not zero
  kWideAddress,  ///< an entry point or destination above the DSP's 22 bits
  kCutBlock,     ///< ends within a block
  kNoEnd,        ///< no block of size 0 at the end
  kTrailing,     ///< bytes behind the end
  kNoBlocks,     ///< nothing would be loaded
};

struct ImageReport {
  ImageDefect defect = ImageDefect::kNone;
  std::size_t offset = 0;   ///< byte where the defect was met
  std::size_t size = 0;     ///< of the image
  std::uint32_t entry = 0;  ///< address of the first instruction
  std::size_t blocks = 0;   ///< checked so far
  std::size_t words = 0;    ///< in these blocks
};

/// Checks the container from its first to its last byte. Pure; no allocation.
ImageReport check_image(std::span<const std::uint8_t> image);

/// One sentence: what is wrong and where, or what the image holds.
std::string explain(const ImageReport& report);

/// The smallest legal image: one block of two words. A simulated Falcon takes it as its firmware.
///
/// returns   34 bytes
std::array<std::uint8_t, 34> synthetic_image();

/// Reads an image from a file and checks it.
///
/// returns   what is wrong with it; `image` is then as before
Refusal read_image(const std::string& path, std::vector<std::uint8_t>& image);

}  // namespace isotouch::falcon
