/// The angle of a direction, by arithmetic and square roots alone: the same bits on every machine, which no maths library promises.
#pragma once

#include <cmath>
#include <numbers>

namespace isotouch::field {

/// The angle from the x axis to (x, y), radians, -pi to pi, as `atan2`; within 4e-15. (0, 0) has the angle 0.
///
/// source    half-angle formula tan(a / 2) = y / (r + x), three times, then the Taylor series of the arc tangent
inline double angle_of(double y, double x) {
  const double scale = std::abs(x) + std::abs(y);
  if (!(scale > 0)) return 0;
  double across = std::abs(y) / scale;
  double along = std::abs(x) / scale;
  for (int halving = 0; halving < 3; ++halving) along += std::sqrt(along * along + across * across);
  const double t = across / along;  // of an eighth of the angle in the first quadrant: at most tan(pi / 16)
  double series = 0;
  for (int n = 21; n > 0; n -= 2) series = (1.0 / n) - t * t * series;
  const double angle = 8 * t * series;
  const double upper = x < 0 ? std::numbers::pi - angle : angle;
  return y < 0 ? -upper : upper;
}

}  // namespace isotouch::field
