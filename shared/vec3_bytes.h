/// Three quantities as they stand in a record: 12 bytes, x first.
///
/// tick      yes
#pragma once

#include <cstdint>

#include "shared/bytes.h"
#include "shared/vec3.h"

namespace isotouch {

template <class Q>
constexpr void store_vec3(std::uint8_t* at, const Vec3<Q>& v) {
  store_le(at, v.x.raw());
  store_le(at + 4, v.y.raw());
  store_le(at + 8, v.z.raw());
}

template <class Q>
constexpr Vec3<Q> load_vec3(const std::uint8_t* at) {
  return {Q::from_raw(load_le<std::int32_t>(at)), Q::from_raw(load_le<std::int32_t>(at + 4)), Q::from_raw(load_le<std::int32_t>(at + 8))};
}

}  // namespace isotouch
