/// Image → PNG file, 8 bits a channel, sRGB.
#pragma once

#include <filesystem>
#include <vector>

#include "host/view/image.h"

namespace isotouch::view {

/// fails     std::bad_alloc only
std::vector<std::uint8_t> encode_png(const Image& image);

/// The whole new file or the old one, never half of one.
///
/// fails     InputError naming the file
void write_png(const std::filesystem::path& file, const Image& image);

}  // namespace isotouch::view
