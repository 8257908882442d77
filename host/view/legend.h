/// The legend of a plot: what its lines and areas mean, in a row above the frame, filled from the right to the left.
///
/// real time   no
#pragma once

#include <functional>
#include <string>

#include "host/view/canvas.h"

namespace isotouch::view {

class Legend {
 public:
  /// canvas    must live as long as the legend
  /// area      the inside of the plot's frame, pixels of the picture
  Legend(Canvas& canvas, const Rect& area);

  /// Draws an entry for a line, to the left of the entries before. Nothing is drawn if the text is empty.
  ///
  /// width     of the line, pixels on a picture of 960 x 720; it is scaled with the picture
  /// broken    the line is dashed
  /// fails     never
  void add_line(const std::string& text, Colour colour, float width, bool broken);
  /// Draws an entry for an area, as add_line does.
  void add_area(const std::string& text, Colour colour);

 private:
  /// Draws the text, and the sign beside it in the rectangle that it is given.
  void add(const std::string& text, const std::function<void(const Rect& sign)>& draw_sign);

  Canvas& canvas_;
  float scale_, right_, base_line_;
};

}  // namespace isotouch::view
