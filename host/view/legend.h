/// What the lines and areas of a plot are, in a row above its frame, from the right to the left.
#pragma once

#include <functional>
#include <string>

#include "host/view/canvas.h"

namespace isotouch::view {

class Legend {
 public:
  /// area      the inside of the plot's frame, pixels
  Legend(Canvas& canvas, const Rect& area);

  /// Adds a line as it is in the plot, to the left of what is there. Without a text nothing is added.
  ///
  /// width     pixels on a picture of 960 x 720
  void add_line(const std::string& text, Colour colour, float width, bool broken);
  /// The same for an area.
  void add_area(const std::string& text, Colour colour);

 private:
  /// Draws the text, and the sign beside it in the rectangle that it is given.
  void add(const std::string& text, const std::function<void(const Rect& sign)>& draw_sign);

  Canvas& canvas_;
  float scale_, right_, base_line_;
};

}  // namespace isotouch::view
