/// A dense scan made as dense as the grid can use.
#pragma once

#include "host/cloud/oriented_points.h"

namespace isotouch::field {

/// Keeps one sample of every group that shares a cell and a direction: the one nearest to the group's mean, so no sample is moved off the surface;
/// its stiffness is the group's mean.
/// A group whose normals oppose one three times its size is taken for stray normals and left out; two sides of a thin part, of like size, both stay.
///
/// points    index coordinates, voxels; unit normals
/// cell      edge, voxels; above 0
/// returns   in the order of the cells; the same points for any order of the input, except where two lie equally near a mean
/// source    voxel-grid filter with normals; cost N log N
cloud::OrientedPoints thinned(const cloud::OrientedPoints& points, double cell);

}  // namespace isotouch::field
