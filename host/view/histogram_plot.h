/// How many values lie in which class: both axes logarithmic, so that one late tick among millions is seen.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "host/view/canvas.h"

namespace isotouch::view {

/// Classes of values by rising bounds.
struct ValueClass {
  double up_to;  ///< upper bound, in the unit of the plot; one below 0.001 is drawn at 0.001
  double count;  ///< how many values lie in the class, 0 or more
};

struct HistogramPlot {
  std::string title;
  std::string unit;                 ///< of the bounds
  std::vector<ValueClass> classes;  ///< drawn as bars; empty: a sentence says so
  std::vector<ValueClass> beside;   ///< on the same axes, as a line; empty: there is none
  std::string label, beside_label;  ///< in the legend; empty: not named there
  std::optional<double> limit;      ///< a broken line; nothing: there is none

  /// Draws axes, bars, line and legend into `place`, in pixels of the canvas.
  void draw(Canvas& canvas, const Rect& place) const;
};

/// Counts by quarters of an octave, whatever classes they came in, so that two histograms can be drawn on each other.
std::vector<ValueClass> by_quarter_octaves(const std::vector<ValueClass>& classes);

}  // namespace isotouch::view
