#include "host/view/png_file.h"

#include <png.h>

#include <new>

#include "host/files/whole_file.h"

namespace isotouch::view {

std::vector<std::uint8_t> encode_png(const Image& image) {
  std::vector<std::uint8_t> pixels;
  pixels.reserve(static_cast<std::size_t>(image.width()) * static_cast<std::size_t>(image.height()) * 3);
  for (int y = 0; y < image.height(); ++y) {
    for (int x = 0; x < image.width(); ++x) {
      const Colour& c = image.at(x, y);
      pixels.insert(pixels.end(), {to_byte(c.r), to_byte(c.g), to_byte(c.b)});
    }
  }
  png_image description{};
  description.version = PNG_IMAGE_VERSION;
  description.width = static_cast<png_uint_32>(image.width());
  description.height = static_cast<png_uint_32>(image.height());
  description.format = PNG_FORMAT_RGB;
  png_alloc_size_t bytes = PNG_IMAGE_PNG_SIZE_MAX(description);
  std::vector<std::uint8_t> png(bytes);
  if (png_image_write_to_memory(&description, png.data(), &bytes, 0, pixels.data(), 0, nullptr) == 0) throw std::bad_alloc();
  png.resize(bytes);
  return png;
}

void write_png(const std::filesystem::path& file, const Image& image) {
  const std::vector<std::uint8_t> png = encode_png(image);
  write_file(file, png.data(), png.size());
}

}  // namespace isotouch::view
