#include "host/view/picture.h"

#include <cairo-pdf.h>
#include <cairo-svg.h>

#include <cstring>
#include <new>
#include <string>

#include "host/files/whole_file.h"

namespace isotouch::view {
namespace {

constexpr double kPointsPerPixel = 72.0 / 96.0;

void require(cairo_status_t status) {
  if (status != CAIRO_STATUS_SUCCESS) throw std::bad_alloc();  // nothing else can fail: all that is drawn is valid
}

cairo_status_t append(void* to, const unsigned char* bytes, unsigned int size) {
  auto& all = *static_cast<std::vector<std::uint8_t>*>(to);
  all.insert(all.end(), bytes, bytes + size);
  return CAIRO_STATUS_SUCCESS;
}

float light_of(std::uint32_t pixel, int shift) { return srgb((pixel >> shift) & 0xFFU).b; }

}  // namespace

Picture::Picture(int width, int height, Colour ground) : width_(width), height_(height) {
  const cairo_rectangle_t all{0, 0, static_cast<double>(width), static_cast<double>(height)};
  drawn_.reset(cairo_recording_surface_create(CAIRO_CONTENT_COLOR, &all));
  pen_.reset(cairo_create(drawn_.get()));
  const auto share = [](float light) { return to_byte(light) / 255.0; };
  cairo_set_source_rgb(pen(), share(ground.r), share(ground.g), share(ground.b));
  cairo_paint(pen());
}

void Picture::draw_on(cairo_surface_t* surface) const {
  require(cairo_status(pen()));
  const Pen copy(cairo_create(surface));
  cairo_set_source_surface(copy.get(), drawn_.get(), 0, 0);
  cairo_paint(copy.get());
  cairo_surface_finish(surface);
  require(cairo_status(copy.get()));
  require(cairo_surface_status(surface));
}

Picture::Surface Picture::rasterised() const {
  require(cairo_status(pen()));
  Surface surface(cairo_image_surface_create(CAIRO_FORMAT_RGB24, width_, height_));
  const Pen copy(cairo_create(surface.get()));
  cairo_set_source_surface(copy.get(), drawn_.get(), 0, 0);
  cairo_paint(copy.get());
  cairo_surface_flush(surface.get());
  require(cairo_status(copy.get()));
  return surface;
}

Image Picture::pixels() const {
  const Surface surface = rasterised();
  const unsigned char* bytes = cairo_image_surface_get_data(surface.get());
  const auto stride = static_cast<std::size_t>(cairo_image_surface_get_stride(surface.get()));
  Image image(width_, height_);
  for (int y = 0; y < height_; ++y) {
    for (int x = 0; x < width_; ++x) {
      std::uint32_t pixel = 0;
      std::memcpy(&pixel, bytes + static_cast<std::size_t>(y) * stride + 4 * static_cast<std::size_t>(x), sizeof pixel);
      image.at(x, y) = {light_of(pixel, 16), light_of(pixel, 8), light_of(pixel, 0)};
    }
  }
  return image;
}

std::vector<std::uint8_t> encode(const Picture& picture, std::string_view ending) {
  std::vector<std::uint8_t> bytes;
  const double width = picture.width(), height = picture.height();
  if (ending == ".svg") {
    const Picture::Surface surface(cairo_svg_surface_create_for_stream(append, &bytes, width, height));
    cairo_svg_surface_set_document_unit(surface.get(), CAIRO_SVG_UNIT_PX);
    picture.draw_on(surface.get());
  } else if (ending == ".pdf") {
    const Picture::Surface surface(cairo_pdf_surface_create_for_stream(append, &bytes, width * kPointsPerPixel, height * kPointsPerPixel));
    cairo_pdf_surface_restrict_to_version(surface.get(), CAIRO_PDF_VERSION_1_4);  // nothing needs more, and every reader has it
    cairo_pdf_surface_set_metadata(surface.get(), CAIRO_PDF_METADATA_CREATE_DATE, "1970-01-01T00:00:00Z");  // else two runs differ
    cairo_surface_set_device_scale(surface.get(), kPointsPerPixel, kPointsPerPixel);
    picture.draw_on(surface.get());
  } else {
    require(cairo_surface_write_to_png_stream(picture.rasterised().get(), append, &bytes));
  }
  return bytes;
}

void write_picture(const std::filesystem::path& file, const Picture& picture) {
  std::string ending = file.extension().string();
  for (char& c : ending) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  const std::vector<std::uint8_t> bytes = encode(picture, ending);
  write_file(file, bytes.data(), bytes.size());
}

}  // namespace isotouch::view
