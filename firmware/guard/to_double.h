/// Fixed-point numbers as doubles.
#pragma once

#include <cmath>

#include "firmware/guard/arm_geometry.h"
#include "shared/fixed.h"
#include "shared/vec3.h"

namespace isotouch::guard {

template <class U, int F>
double to_double(const Fixed<U, F>& value) {
  return std::ldexp(value.raw(), -F);
}

template <class T>
Point to_point(const Vec3<T>& v) {
  return {to_double(v.x), to_double(v.y), to_double(v.z)};
}

}  // namespace isotouch::guard
