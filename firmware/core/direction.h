/// Directions and lengths along them, for differences of points within ±8191 voxels: below 2^30 a component, so that three squares fit 63 bits.
///
/// tick      yes
#pragma once

#include <cstdint>

#include "shared/roots.h"
#include "shared/units.h"
#include "shared/vec3.h"

namespace isotouch::core {

/// The unit vector of v, 30 fraction bits; zero for zero.
///
/// square    dot_raw(v, v)
inline Vec3<Ratio> direction(const Vec3<Voxel>& v, std::int64_t square) {
  const Reciprocal inverse = inverse_root(static_cast<std::uint64_t>(square));
  const auto part = [&](Voxel q) { return Ratio::from_raw(static_cast<std::int32_t>(share_of_root(q.raw(), inverse))); };
  return {part(v.x), part(v.y), part(v.z)};
}
inline Vec3<Ratio> direction(const Vec3<Voxel>& v) { return direction(v, dot_raw(v, v)); }

/// How far v reaches along a unit vector.
inline Voxel along(const Vec3<Voxel>& v, const Vec3<Ratio>& unit) {
  return Voxel::from_raw(saturate32(dot_raw(v, unit) >> Ratio::kFractionBits));
}

/// A length along a unit vector.
inline Vec3<Voxel> reaching(Voxel length, const Vec3<Ratio>& unit) {
  return {part_of(length, unit.x), part_of(length, unit.y), part_of(length, unit.z)};
}

/// The part of v in the plane across a unit vector.
inline Vec3<Voxel> across(const Vec3<Voxel>& v, const Vec3<Ratio>& unit) { return v - reaching(along(v, unit), unit); }

}  // namespace isotouch::core
