/// The stiffness of the surface at a point: the field's table of it, interpolated (SPEC.md 2.4).
///
/// source    k = K(x, y, z): Sreeni, Distance Field based Haptic Rendering of Scattered Oriented Points, section 2.1
#pragma once

#include "shared/field_view.h"
#include "shared/units.h"
#include "shared/vec3.h"

namespace isotouch::core {

/// Trilinear between the centres of the eight nearest bricks; those without a value are left out, and the others weigh accordingly more.
///
/// point     index coordinates, within ±8191 voxels; outside the outermost bricks' centres it is moved there
/// field     with a table
/// largest   what the table's 255 stands for: the field's stiffness, or the settings'
/// returns   above 0, at most `largest`, and just that where all bricks have it or no stored brick is near; continuous within every stored
///           brick, and so wherever the proxy is held
/// fails     never
/// tick      yes: eight look-ups, constant cost, no division
Stiffness interpolated_stiffness(const Vec3<Voxel>& point, const FieldView& field, Stiffness largest);

/// The same for any field; one without a table has `largest` everywhere.
inline Stiffness stiffness_at(const Vec3<Voxel>& point, const FieldView& field, Stiffness largest) {
  return field.stiffness_parts == nullptr ? largest : interpolated_stiffness(point, field, largest);
}

}  // namespace isotouch::core
