/// Lengths against limits, without a root.
#pragma once

#include <algorithm>
#include <cstdint>

#include "shared/vec3.h"

namespace isotouch::core {

/// Is a vector longer than the limit? Components are clamped to 2^30, so that three squares fit 63 bits; the limit is below that.
///
/// tick      yes
template <class Q>
bool is_longer(const Vec3<Q>& v, Q limit) {
  const Q most = Q::from_raw(1 << 30);
  const auto bounded = [most](Q q) { return std::clamp(q, -most, most); };
  const Vec3<Q> b = {bounded(v.x), bounded(v.y), bounded(v.z)};
  return dot_raw(b, b) > std::int64_t{limit.raw()} * limit.raw();
}

}  // namespace isotouch::core
