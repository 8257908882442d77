/// The field at a point: value, gradient and second derivatives of the field's quadratic B-spline (SPEC.md 2.1).
///
/// All three come from one function, so they are consistent; value and gradient are continuous across cells.
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
/// returns   the sample; distance within ±8 voxels, error against the exact spline below 2^-14 voxel, gradient below 2^-13
/// fails     never
/// tick      yes: 27 coefficients, constant cost, no division
/// source    quadratic B-spline: de Boor, A Practical Guide to Splines, 1978, chapter IX
void sample_field(const FieldView& field, const Vec3<Voxel>& point, FieldSample& sample);
inline FieldSample sample_field(const FieldView& field, const Vec3<Voxel>& point) {
  FieldSample sample;
  sample_field(field, point, sample);
  return sample;
}

}  // namespace isotouch::core
