/// Lines over a common axis: values against time.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "host/view/axes.h"
#include "host/view/canvas.h"

namespace isotouch::view {

struct Series {
  std::string label;         ///< in the legend; empty: not named there
  std::vector<double> x, y;  ///< equally many; x ascending; a y that is not finite interrupts the line
  Colour colour;
  float width = 1.8F;   ///< pixels on a picture of 960 x 720
  bool broken = false;  ///< drawn in dashes
};

struct Plot {
  std::string title;
  std::string x_label, y_label;
  std::vector<Series> series;                        ///< later ones lie on top
  std::vector<std::pair<double, double>> bands;      ///< of x, shaded over the whole height
  std::string band_label;                            ///< in the legend; empty: not named there
  std::optional<std::pair<double, double>> y_range;  ///< none: what the series need and a little more, with 0 when it is near

  /// The axes that `draw` uses for a plot that fills `place` with all its labels.
  Axes axes(const Rect& place, float scale) const;
  void draw(Canvas& canvas, const Rect& place) const;
};

}  // namespace isotouch::view
