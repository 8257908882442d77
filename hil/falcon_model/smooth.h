/// The way of a hand from rest to rest.
#pragma once

#include <algorithm>

namespace isotouch::falcon_model {

/// From 0 to 1 with the least jerk while s goes from 0 to 1, constant outside; largest slope 1.875.
///
/// source    Flash and Hogan, The coordination of arm movements, 1985
constexpr double smooth(double s) {
  const double t = std::clamp(s, 0.0, 1.0);
  return t * t * t * (10 + t * (6 * t - 15));
}

}  // namespace isotouch::falcon_model
