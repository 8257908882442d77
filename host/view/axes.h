/// A pair of axes with round ticks: from values to pixels and the frame around them.
#pragma once

#include <string>
#include <vector>

#include "host/view/canvas.h"

namespace isotouch::view {

struct Axis {
  std::string label;
  double low = 0, high = 1;  ///< low < high
};

inline const Colour kGrid = srgb(0xE3E7EC);

/// The inside of the frame of a plot that fills `place` with its title, legend and labels.
///
/// scale     `drawing_scale` of the picture
Rect frame_in(const Rect& place, float scale);

/// Round values within [low, high], at most `most` of them, ascending, a multiple of 1, 2 or 5 times a power of ten apart. None where the range is
/// empty or not finite.
///
/// most      1 or more
std::vector<double> ticks(double low, double high, int most);

/// A value as a tick shows it, with the digits that tell it from its neighbour.
std::string tick_text(double value, double step);

class Axes {
 public:
  /// area      the frame's inside, pixels; labels stand to the left and below
  Axes(const Rect& area, Axis x, Axis y) : area_(area), x_(std::move(x)), y_(std::move(y)) {}

  const Rect& area() const { return area_; }
  Point at(double x, double y) const;
  double x_of(double pixel) const {
    return x_.low + (pixel - static_cast<double>(area_.left)) / static_cast<double>(area_.width()) * (x_.high - x_.low);
  }
  double y_of(double pixel) const {
    return y_.high - (pixel - static_cast<double>(area_.top)) / static_cast<double>(area_.height()) * (y_.high - y_.low);
  }

  void draw_grid(Canvas& canvas) const;
  void draw_frame(Canvas& canvas) const;

 private:
  std::vector<double> x_ticks(const Canvas& canvas) const;
  std::vector<double> y_ticks(const Canvas& canvas) const;

  Rect area_;
  Axis x_, y_;
};

}  // namespace isotouch::view
