/// Figures of a report as inline SVG: light, readable without a script, the same on every machine.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "host/link/controller.h"

namespace isotouch::qualify {

/// Text as it stands in HTML.
std::string escaped(const std::string& text);

/// A number with three digits that count: 0.0123, 1.23, 123, 12345.
std::string short_number(double value);

/// How many values lie in which class: both axes logarithmic, so that one late tick among millions is seen.
///
/// unit_ns   of the axis
/// limit_ns  a line; nothing: there is none
/// beside    another histogram on the same axes, as a line; empty: there is none
std::string histogram_svg(const link::Histogram& histogram, double unit_ns, const std::string& unit, std::optional<double> limit_ns,
                          const link::Histogram& beside);

struct Sample {
  double second, value;
};
/// A value over time.
std::string course_svg(const std::vector<Sample>& samples, const std::string& unit);

}  // namespace isotouch::qualify
