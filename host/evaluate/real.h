/// Quantities as plain numbers in their unit: exact, for measuring and showing. The way back rounds to nearest.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <cstdint>

#include "shared/fixed.h"
#include "shared/vec3.h"

namespace isotouch::evaluate {

template <class U, int F>
double real(Fixed<U, F> quantity) {
  return static_cast<double>(quantity.raw()) / static_cast<double>(std::int64_t{1} << F);
}

template <class Q>
Eigen::Vector3d real(const Vec3<Q>& v) {
  return {real(v.x), real(v.y), real(v.z)};
}

/// The nearest quantity, saturated; ties up.
template <class Q>
Q nearest(double value) {
  const double scaled = std::floor(value * static_cast<double>(std::int64_t{1} << Q::kFractionBits) + 0.5);
  return Q::from_raw(static_cast<std::int32_t>(std::clamp(scaled, -2147483648.0, 2147483647.0)));
}

template <class Q>
Vec3<Q> nearest(const Eigen::Vector3d& v) {
  return {nearest<Q>(v.x()), nearest<Q>(v.y()), nearest<Q>(v.z())};
}

}  // namespace isotouch::evaluate
