#include "host/view/canvas.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <memory>
#include <numbers>

namespace isotouch::view {
namespace {

constexpr double kFarthest = 1e6;  // pixels: Cairo counts in 24 bits before the point

double near(float value) { return std::clamp(static_cast<double>(value), -kFarthest, kFarthest); }

std::uint32_t pixel_of(const Colour& c) { return std::uint32_t{to_byte(c.r)} << 16 | std::uint32_t{to_byte(c.g)} << 8 | to_byte(c.b); }

}  // namespace

Canvas Canvas::within(Rect clip) const {
  Canvas part = *this;
  part.clip_ = {std::max(clip.left, clip_.left), std::max(clip.top, clip_.top), std::min(clip.right, clip_.right),
                std::min(clip.bottom, clip_.bottom)};
  return part;
}

cairo_t* Canvas::begin(Colour colour, float alpha) {
  cairo_t* pen = picture_.pen();
  cairo_save(pen);
  cairo_rectangle(pen, near(clip_.left), near(clip_.top), std::max(0.0, near(clip_.width())), std::max(0.0, near(clip_.height())));
  cairo_clip(pen);
  const std::uint32_t pixel = pixel_of(colour);
  const auto share = [pixel](int shift) { return ((pixel >> shift) & 0xFFU) / 255.0; };
  cairo_set_source_rgba(pen, share(16), share(8), share(0), static_cast<double>(alpha));
  return pen;
}

void Canvas::end() { cairo_restore(picture_.pen()); }

void Canvas::paint(const Image& image, int left, int top) {
  const std::unique_ptr<cairo_surface_t, void (*)(cairo_surface_t*)> surface(
      cairo_image_surface_create(CAIRO_FORMAT_RGB24, image.width(), image.height()), cairo_surface_destroy);
  if (cairo_surface_status(surface.get()) != CAIRO_STATUS_SUCCESS) throw std::bad_alloc();
  cairo_surface_flush(surface.get());
  unsigned char* bytes = cairo_image_surface_get_data(surface.get());
  const auto stride = static_cast<std::size_t>(cairo_image_surface_get_stride(surface.get()));
  for (int y = 0; y < image.height(); ++y) {
    for (int x = 0; x < image.width(); ++x) {
      const std::uint32_t pixel = pixel_of(image.at(x, y));
      std::memcpy(bytes + static_cast<std::size_t>(y) * stride + 4 * static_cast<std::size_t>(x), &pixel, sizeof pixel);
    }
  }
  cairo_surface_mark_dirty(surface.get());
  with_pen({}, 1, [&](cairo_t* pen) {
    cairo_set_source_surface(pen, surface.get(), left, top);
    cairo_pattern_set_filter(cairo_get_source(pen), CAIRO_FILTER_NEAREST);
    cairo_rectangle(pen, left, top, image.width(), image.height());
    cairo_fill(pen);
  });
}

void Canvas::fill(Rect area, Colour colour, float alpha) {
  with_pen(colour, alpha, [&](cairo_t* pen) {
    const double left = near(area.left), top = near(area.top);
    cairo_rectangle(pen, left, top, std::max(0.0, near(area.right) - left), std::max(0.0, near(area.bottom) - top));
    cairo_fill(pen);
  });
}

void Canvas::disc(Point centre, float radius, Colour colour, float alpha) {
  with_pen(colour, alpha, [&](cairo_t* pen) {
    cairo_arc(pen, near(centre.x), near(centre.y), static_cast<double>(radius), 0, 2 * std::numbers::pi);
    cairo_fill(pen);
  });
}

void Canvas::stroke(std::span<const Polyline> lines, float width, Colour colour, float alpha) {
  with_pen(colour, alpha, [&](cairo_t* pen) {
    cairo_set_line_width(pen, static_cast<double>(width));
    cairo_set_line_cap(pen, CAIRO_LINE_CAP_ROUND);
    cairo_set_line_join(pen, CAIRO_LINE_JOIN_ROUND);
    for (const Polyline& line : lines) {
      for (std::size_t i = 0; i < line.size(); ++i) (i == 0 ? cairo_move_to : cairo_line_to)(pen, near(line[i].x), near(line[i].y));
      if (line.size() == 1) cairo_line_to(pen, near(line[0].x), near(line[0].y));
    }
    cairo_stroke(pen);
  });
}

void Canvas::line(Point from, Point to, float width, Colour colour, float alpha) {
  const Polyline one = {from, to};
  stroke({&one, 1}, width, colour, alpha);
}

void Canvas::frame(Rect area, float width, Colour colour, float alpha) {
  const Polyline one = {
      {area.left, area.top}, {area.right, area.top}, {area.right, area.bottom}, {area.left, area.bottom}, {area.left, area.top}};
  stroke({&one, 1}, width, colour, alpha);
}

std::vector<Polyline> dashed(const Polyline& line, float dash, float gap) {
  std::vector<Polyline> pieces;
  bool drawing = true;
  float left = dash;  // of the present dash or gap
  if (!line.empty()) pieces.push_back({line.front()});
  for (std::size_t i = 1; i < line.size(); ++i) {
    Point from = line[i - 1];
    const Point to = line[i];
    float length = std::hypot(to.x - from.x, to.y - from.y);
    while (length > left) {
      from = from + (to - from) * (left / length);
      length -= left;
      if (drawing) {
        pieces.back().push_back(from);
      } else {
        pieces.push_back({from});
      }
      drawing = !drawing;
      left = drawing ? dash : gap;
    }
    left -= length;
    if (drawing) pieces.back().push_back(to);
  }
  return pieces;
}

}  // namespace isotouch::view
