/// Quantities as plain numbers in their unit: exact, for measuring and showing. The way back rounds to nearest.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <cstdint>

#include "shared/fixed.h"
#include "shared/vec3.h"

namespace isotouch {

template <class U, int F>
double to_double(Fixed<U, F> quantity) {
  return static_cast<double>(quantity.raw()) / static_cast<double>(std::int64_t{1} << F);
}

template <class Q>
Eigen::Vector3d to_double(const Vec3<Q>& v) {
  return {to_double(v.x), to_double(v.y), to_double(v.z)};
}

/// The nearest quantity, saturated; ties up.
template <class Q>
Q to_fixed(double value) {
  const double scaled = std::floor(value * static_cast<double>(std::int64_t{1} << Q::kFractionBits) + 0.5);
  return Q::from_raw(static_cast<std::int32_t>(std::clamp(scaled, -2147483648.0, 2147483647.0)));
}

template <class Q>
Vec3<Q> to_fixed(const Eigen::Vector3d& v) {
  return {to_fixed<Q>(v.x()), to_fixed<Q>(v.y()), to_fixed<Q>(v.z())};
}

}  // namespace isotouch
