#include "host/cloud/depth_png.h"

#include <png.h>

#include <algorithm>
#include <array>
#include <csetjmp>
#include <cstring>
#include <new>

#include "host/error.h"

namespace isotouch::cloud {
namespace {

constexpr std::size_t kMaxGrowth = 1032;     // of deflate: two bits repeat up to 258 bytes
constexpr std::size_t kMaxPixels = 1 << 25;  // larger than any sensor's, and an empty image packs a thousandfold
constexpr std::size_t kHeaderBytes = 33;     // signature and IHDR

/// What libpng reads from and reports to.
struct Source {
  std::span<const std::uint8_t> left;
  std::array<char, 128> complaint{};
};

void read(png_structp png, png_bytep to, png_size_t count) {
  auto& source = *static_cast<Source*>(png_get_io_ptr(png));
  if (count > source.left.size()) png_error(png, "it was cut short");
  std::copy_n(source.left.begin(), count, to);
  source.left = source.left.subspan(count);
}

[[noreturn]] void fail(png_structp png, png_const_charp complaint) {
  auto& source = *static_cast<Source*>(png_get_error_ptr(png));
  std::strncpy(source.complaint.data(), complaint, source.complaint.size() - 1);
  png_longjmp(png, 1);
}

void ignore(png_structp, png_const_charp) {}

/// libpng's reader, gone with this.
struct Reader {
  png_structp png;
  png_infop info;

  explicit Reader(Source& source)
      : png(png_create_read_struct(PNG_LIBPNG_VER_STRING, &source, fail, ignore)),
        info(png == nullptr ? nullptr : png_create_info_struct(png)) {
    if (info == nullptr) throw std::bad_alloc();
    png_set_read_fn(png, &source, read);
  }
  Reader(const Reader&) = delete;
  Reader& operator=(const Reader&) = delete;
  ~Reader() { png_destroy_read_struct(&png, &info, nullptr); }
};

// libpng leaves by longjmp, so these two create nothing that a destructor would have to release.
bool read_info(const Reader& reader) {
  if (setjmp(png_jmpbuf(reader.png)) != 0) return false;
  png_read_info(reader.png, reader.info);
  return true;
}
bool read_rows(const Reader& reader, png_bytepp rows) {
  if (setjmp(png_jmpbuf(reader.png)) != 0) return false;
  png_read_image(reader.png, rows);
  png_read_end(reader.png, nullptr);
  return true;
}

}  // namespace

DepthPixels read_depth_png(const std::string& name, std::span<const std::uint8_t> bytes) {
  Source source{bytes};
  const Reader reader(source);
  const auto damaged = [&] { return InputError(name + ": the PNG file is damaged: " + source.complaint.data()); };
  if (!read_info(reader)) throw damaged();
  const int bits = png_get_bit_depth(reader.png, reader.info);
  if (bits != 16 || png_get_color_type(reader.png, reader.info) != PNG_COLOR_TYPE_GRAY) {
    throw InputError(name + ": a depth image holds one 16-bit grey value a pixel, this PNG file has " + std::to_string(bits) +
                     " bits and " + std::to_string(png_get_channels(reader.png, reader.info)) +
                     " channels; name the depth image, not a picture of it");
  }
  const std::size_t width = png_get_image_width(reader.png, reader.info), height = png_get_image_height(reader.png, reader.info);
  const std::size_t row_bytes = 2 * width;
  if (height > std::uint64_t{bytes.size() - kHeaderBytes} * kMaxGrowth / row_bytes) {
    throw InputError(name + ": it claims " + std::to_string(width) + " × " + std::to_string(height) +
                     " pixels, more than the file has room for; it was cut short or is damaged");
  }
  if (height > kMaxPixels / width) {
    throw InputError(name + ": " + std::to_string(width) + " × " + std::to_string(height) + " pixels are more than the " +
                     std::to_string(kMaxPixels) + " that a depth image may have; make it smaller");
  }
  std::vector<std::uint8_t> stored(row_bytes * height);
  std::vector<png_bytep> rows(height);
  for (std::size_t row = 0; row < height; ++row) rows[row] = stored.data() + row * row_bytes;
  if (!read_rows(reader, rows.data())) throw damaged();
  DepthPixels pixels{width, std::vector<std::uint16_t>(width * height)};
  for (std::size_t i = 0; i < pixels.depth.size(); ++i)
    pixels.depth[i] = static_cast<std::uint16_t>(stored[2 * i] << 8 | stored[2 * i + 1]);
  return pixels;
}

}  // namespace isotouch::cloud
