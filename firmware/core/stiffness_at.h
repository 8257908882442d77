/// The stiffness of the surface at a point: the field's table of it, interpolated (SPEC.md 2.4).
///
/// source    k = K(x, y, z): Sreeni, Distance Field based Haptic Rendering of Scattered Oriented Points, section 2.1
#pragma once

#include "shared/field_view.h"
#include "shared/units.h"
#include "shared/vec3.h"

namespace isotouch::core {

/// Change of a logarithm over a voxel. Range ±127.
using PerVoxel = Fixed<Unit<0, 0, 0, -1>, 24>;

struct StiffnessSample {
  Ratio part = Ratio::of(1);  ///< of the largest stiffness; above 0, at most 1
  Vec3<PerVoxel> slope;       ///< gradient of the part over the part: ∇ ln k, index coordinates, within ±127
};

/// A quadratic B-spline over the 27 nearest bricks; those without a value are left out, and the others weigh accordingly more. So the stiffness has
/// no kinks, and a force that follows its slope has no leaps.
///
/// point     index coordinates, within ±8191 voxels; outside the outermost bricks' centres it is moved there
/// field     with a table
/// returns   1 and no slope where all bricks have the largest stiffness or no stored brick is near; continuous within every stored brick, and so
///           wherever the proxy is held
/// fails     never
/// tick      yes: 27 look-ups, constant cost, no division
StiffnessSample sample_stiffness(const Vec3<Voxel>& point, const FieldView& field);

/// For any field; one without a table has `largest` everywhere.
///
/// largest   what the table's 255 stands for: the field's stiffness, or the settings'
inline Stiffness stiffness_at(const Vec3<Voxel>& point, const FieldView& field, Stiffness largest) {
  return field.stiffness_parts == nullptr ? largest : mul<Stiffness>(largest, sample_stiffness(point, field).part);
}

}  // namespace isotouch::core
