/// Draws on a picture. Positions are in pixels, x to the right, y down, (0, 0) the top left corner.
#pragma once

#include <span>
#include <vector>

#include "host/view/image.h"
#include "host/view/picture.h"

namespace isotouch::view {

struct Point {
  float x = 0, y = 0;
  Point operator+(Point o) const { return {x + o.x, y + o.y}; }
  Point operator-(Point o) const { return {x - o.x, y - o.y}; }
  Point operator*(float f) const { return {x * f, y * f}; }
};

struct Rect {
  float left = 0, top = 0, right = 0, bottom = 0;
  float width() const { return right - left; }
  float height() const { return bottom - top; }
};

using Polyline = std::vector<Point>;

/// Draws on a picture that outlives it; what lies outside `clip` stays as it was.
class Canvas {
 public:
  explicit Canvas(Picture& picture)
      : picture_(picture), clip_{0, 0, static_cast<float>(picture.width()), static_cast<float>(picture.height())} {}
  /// The same picture with drawing limited to `clip`.
  Canvas within(Rect clip) const;

  const Picture& picture() const { return picture_; }
  /// Lays an image over the picture, its top left corner at whole pixels.
  void paint(const Image& image, int left = 0, int top = 0);
  void fill(Rect area, Colour colour, float alpha = 1);
  void disc(Point centre, float radius, Colour colour, float alpha = 1);
  /// One stroke with round ends and joints through all lines at once: where they cross, the colour is laid on once.
  void stroke(std::span<const Polyline> lines, float width, Colour colour, float alpha = 1);
  void line(Point from, Point to, float width, Colour colour, float alpha = 1);
  void frame(Rect area, float width, Colour colour, float alpha = 1);
  /// Draws with Cairo within the clip.
  template <class Draw>
  void with_pen(Colour colour, float alpha, const Draw& draw) {
    draw(begin(colour, alpha));
    end();
  }

 private:
  cairo_t* begin(Colour colour, float alpha);
  void end();

  Picture& picture_;
  Rect clip_;
};

/// The same lines cut into dashes.
std::vector<Polyline> dashed(const Polyline& line, float dash, float gap);

}  // namespace isotouch::view
