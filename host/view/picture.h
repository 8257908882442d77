/// A picture in layers: areas, lines, letters and images of pixels. It is kept as what was drawn, and written as PNG, SVG or PDF.
///
/// source    Cairo, which draws and writes
#pragma once

#include <cairo.h>

#include <cstdint>
#include <filesystem>
#include <memory>
#include <vector>

#include "host/view/image.h"

namespace isotouch::view {

class Picture {
 public:
  /// width, height   pixels
  Picture(int width, int height, Colour ground = {1, 1, 1});

  int width() const { return width_; }
  int height() const { return height_; }

  /// What it looks like, pixel by pixel.
  Image pixels() const;

  /// Cairo's, for whoever draws; lives as long as the picture.
  cairo_t* pen() const { return pen_.get(); }

 private:
  friend std::vector<std::uint8_t> encode(const Picture& picture, std::string_view ending);
  struct Close {
    void operator()(cairo_surface_t* surface) const { cairo_surface_destroy(surface); }
    void operator()(cairo_t* pen) const { cairo_destroy(pen); }
  };
  using Surface = std::unique_ptr<cairo_surface_t, Close>;
  using Pen = std::unique_ptr<cairo_t, Close>;

  /// Draws everything once more.
  void draw_on(cairo_surface_t* surface) const;
  Surface rasterised() const;

  int width_, height_;
  Surface drawn_;
  Pen pen_;
};

/// The bytes of a file. The same picture gives the same bytes in every run of a program.
///
/// ending    ".png", ".svg" or ".pdf"; a pixel is 1/96 inch in a PDF
std::vector<std::uint8_t> encode(const Picture& picture, std::string_view ending);

/// Writes it in the format that the file's name asks for, without a name that says it as PNG.
///
/// fails     InputError naming the file
void write_picture(const std::filesystem::path& file, const Picture& picture);

}  // namespace isotouch::view
