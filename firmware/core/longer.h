/// Lengths against limits, without a root.
#pragma once

#include <cstdint>

#include "shared/vec3.h"

namespace isotouch::core {

/// Is a vector longer than the limit? Three squares fit 64 bits without a sign; the limit is not below 0.
///
/// tick      yes
template <class Q>
bool is_longer(const Vec3<Q>& v, Q limit) {
  const auto square = [](Q q) { return static_cast<std::uint64_t>(product(q.raw(), q.raw())); };
  return square(v.x) + square(v.y) + square(v.z) > square(limit);
}

}  // namespace isotouch::core
