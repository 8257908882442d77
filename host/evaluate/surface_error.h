/// How far a field's surface, as the core samples it, lies from the true one.
#pragma once

#include <cstddef>

#include "host/cloud/oriented_points.h"
#include "shared/field_view.h"

namespace isotouch::evaluate {

/// Over all points that have a crossing; `lost` counts the others, which enter nothing else. All but `lost` is zero where no point has one.
struct SurfaceError {
  std::size_t points = 0;  ///< with a crossing
  std::size_t lost = 0;
  double rms_mm = 0;
  double rms_voxel = 0;
  double p99_voxel = 0;  ///< 99 of 100 offsets are at most this large
  double max_voxel = 0;
  double normal_rms_deg = 0;  ///< angle between the gradient at the crossing and the true normal, 180 where there is no gradient
};

inline constexpr double kSearchVoxels = 2.0;

/// From each point along its normal to the nearest place where the field's zero is passed from inside to outside, within ±2 voxels.
///
/// truth     points on the true surface with its outward unit normals, workspace, mm
SurfaceError crossings_near(const FieldView& field, const cloud::OrientedPoints& truth);

/// The same for a field that should be of this object.
///
/// fails     InputError when not one point has a crossing: nothing was compared
SurfaceError surface_error(const FieldView& field, const cloud::OrientedPoints& truth);

}  // namespace isotouch::evaluate
