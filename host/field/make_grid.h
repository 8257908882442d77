/// The grid that an object is sampled on.
#pragma once

#include <Eigen/Core>

#include "host/field/band_field.h"

namespace isotouch::field {

/// low, high   the box of the points, workspace, mm
/// edge        mm a voxel, rounded to 20 fraction bits
/// margin      voxels between the box and the outermost sample on each side, at least; band + 3 for `build_field`
/// returns     a grid centred on the box; edge and origin are numbers that a field holds exactly
/// fails       InputError when the edge is not within 1/64 to 16 mm, or when an axis has more than 4096 samples
Grid make_grid(const Eigen::Vector3d& low, const Eigen::Vector3d& high, double edge, double margin);

/// The nearest grid whose edge and origin are numbers that a field holds exactly.
Grid exact_grid(Grid grid);

}  // namespace isotouch::field
