/// From the workspace to a field's index coordinates, in which one voxel is 1, and back.
///
/// tick      yes
#pragma once

#include "shared/field_view.h"
#include "shared/units.h"
#include "shared/vec3.h"

namespace isotouch::core {

inline constexpr Voxel kIndexReach = Voxel::of(8191);  ///< twice the largest grid: a difference of two fits 2^30

/// returns   index coordinates; beyond ±kIndexReach the nearest there
inline Vec3<Voxel> to_index(const Vec3<Mm>& point, const FieldView& field) {
  return within(mul<Voxel>(point - field.origin, field.inverse_edge), kIndexReach);
}

inline Vec3<Mm> to_workspace(const Vec3<Voxel>& index, const FieldView& field) { return mul<Mm>(index, field.edge) + field.origin; }

}  // namespace isotouch::core
