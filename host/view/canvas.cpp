#include "host/view/canvas.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace isotouch::view {
namespace {

/// Pixels whose centres lie in an area, as half-open ranges.
struct PixelBox {
  int x0, y0, x1, y1;

  PixelBox(const Rect& area, const Rect& clip)
      : x0(first(std::max(area.left, clip.left))),
        y0(first(std::max(area.top, clip.top))),
        x1(first(std::min(area.right, clip.right))),
        y1(first(std::min(area.bottom, clip.bottom))) {}
  bool empty() const { return x0 >= x1 || y0 >= y1; }

 private:
  static int first(float edge) { return static_cast<int>(std::ceil(std::clamp(edge, -1e6F, 1e6F) - 0.5F)); }
};

/// How much of a pixel lies within `radius` of something whose distance from the pixel's centre is known.
float coverage(float distance, float radius) { return std::clamp(radius - distance + 0.5F, 0.0F, 1.0F); }

float distance_to_segment(Point p, Point a, Point b) {
  const Point ab = b - a, ap = p - a;
  const float length2 = ab.x * ab.x + ab.y * ab.y;
  const float t = length2 > 0 ? std::clamp((ap.x * ab.x + ap.y * ab.y) / length2, 0.0F, 1.0F) : 0.0F;
  return std::hypot(ap.x - t * ab.x, ap.y - t * ab.y);
}

Rect around(Point a, Point b, float margin) {
  return {std::min(a.x, b.x) - margin, std::min(a.y, b.y) - margin, std::max(a.x, b.x) + margin, std::max(a.y, b.y) + margin};
}

Point pixel_centre(int x, int y) { return {static_cast<float>(x) + 0.5F, static_cast<float>(y) + 0.5F}; }

}  // namespace

Canvas Canvas::within(Rect clip) const {
  Canvas part = *this;
  part.clip_ = {std::max(clip.left, clip_.left), std::max(clip.top, clip_.top), std::min(clip.right, clip_.right),
                std::min(clip.bottom, clip_.bottom)};
  return part;
}

void Canvas::fill(Rect area, Colour colour, float alpha) {
  const Rect grown{area.left - 0.5F, area.top - 0.5F, area.right + 0.5F, area.bottom + 0.5F};
  const PixelBox box(grown, clip_);
  const auto overlap = [](int pixel, float low, float high) {
    const auto p = static_cast<float>(pixel);
    return std::clamp(std::min(p + 1, high) - std::max(p, low), 0.0F, 1.0F);
  };
  for (int y = box.y0; y < box.y1; ++y) {
    const float rows = overlap(y, area.top, area.bottom);
    for (int x = box.x0; x < box.x1; ++x) image_.blend(x, y, colour, alpha * rows * overlap(x, area.left, area.right));
  }
}

void Canvas::disc(Point centre, float radius, Colour colour, float alpha) {
  const PixelBox box(around(centre, centre, radius + 1), clip_);
  for (int y = box.y0; y < box.y1; ++y) {
    for (int x = box.x0; x < box.x1; ++x) {
      const Point p = pixel_centre(x, y) - centre;
      image_.blend(x, y, colour, alpha * coverage(std::hypot(p.x, p.y), radius));
    }
  }
}

void Canvas::stroke(std::span<const Polyline> lines, float width, Colour colour, float alpha) {
  const float reach = width / 2 + 1;
  const float far = std::numeric_limits<float>::max();
  Rect all{far, far, -far, -far};
  for (const Polyline& line : lines) {
    for (const Point& p : line) {
      all = {std::min(all.left, p.x - reach), std::min(all.top, p.y - reach), std::max(all.right, p.x + reach),
             std::max(all.bottom, p.y + reach)};
    }
  }
  const PixelBox box(all, clip_);
  if (box.empty()) return;
  const auto columns = static_cast<std::size_t>(box.x1 - box.x0);
  std::vector<float> mask(columns * static_cast<std::size_t>(box.y1 - box.y0), 0.0F);  // the most that any segment covers of each pixel
  const auto cover_segment = [&](Point a, Point b) {
    const PixelBox part(around(a, b, reach), clip_);
    for (int y = part.y0; y < part.y1; ++y) {
      float* row = mask.data() + static_cast<std::size_t>(y - box.y0) * columns;
      for (int x = part.x0; x < part.x1; ++x) {
        float& covered = row[x - box.x0];
        // A line thinner than a pixel covers no pixel wholly.
        const float c = coverage(distance_to_segment(pixel_centre(x, y), a, b), std::max(width, 1.0F) / 2) * std::min(width, 1.0F);
        covered = std::max(covered, c);
      }
    }
  };
  for (const Polyline& line : lines) {
    if (line.size() == 1) cover_segment(line[0], line[0]);
    for (std::size_t i = 1; i < line.size(); ++i) cover_segment(line[i - 1], line[i]);
  }
  for (int y = box.y0; y < box.y1; ++y) {
    const float* row = mask.data() + static_cast<std::size_t>(y - box.y0) * columns;
    for (int x = box.x0; x < box.x1; ++x) image_.blend(x, y, colour, alpha * row[x - box.x0]);
  }
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
