/// The field at a point: value, gradient and second derivatives, by the interpolation that the field's numbers are made for.
#pragma once

#include "shared/field_view.h"
#include "shared/units.h"
#include "shared/vec3.h"

namespace isotouch::core {

using Slope = Fixed<Unit<0, 0, 0, 0>, 16>;       ///< voxels a voxel; range ±32767, resolution 1.5e-5
using Curvature = Fixed<Unit<0, 0, 0, -1>, 16>;  ///< 1 / voxel

struct FieldSample {
  Voxel distance;             ///< negative inside
  Vec3<Slope> gradient;       ///< points out; zero where the field is clamped to the band
  Vec3<Curvature> second;     ///< d²φ/dx², d²φ/dy², d²φ/dz²
  Vec3<Curvature> mixed;      ///< d²φ/dydz, d²φ/dzdx, d²φ/dxdy
  bool outside_grid = false;  ///< the point was moved to the grid's border
};

/// point     index coordinates, within ±8191 voxels; outside the grid it is moved to the border, which is far outside the object
/// returns   the sample: value and gradient are continuous; |distance| <= 8 voxels, |gradient| <= 16 and second derivatives <= 32 a component
/// fails     never
/// tick      yes: constant cost for a field, no division
void sample_field(const FieldView& field, const Vec3<Voxel>& point, FieldSample& sample);
inline FieldSample sample_field(const FieldView& field, const Vec3<Voxel>& point) {
  FieldSample sample;
  sample_field(field, point, sample);
  return sample;
}

}  // namespace isotouch::core
