/// PNG files of one 16-bit number a pixel, as depth cameras' recorders write them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace isotouch::cloud {

struct DepthPixels {
  std::size_t width = 0;
  std::vector<std::uint16_t> depth;  ///< row by row, from the top; the numbers as stored, whatever the file says of gamma
};

/// fails     InputError: no PNG, damaged or cut short, not 16-bit greyscale, larger than its bytes can hold or than 2^25 pixels
DepthPixels read_depth_png(const std::string& name, std::span<const std::uint8_t> bytes);

}  // namespace isotouch::cloud
