/// The stiffness of a scan's samples, carried to the bricks of its field.
#pragma once

#include <vector>

#include "host/field/band_field.h"
#include "host/field/nearest.h"

namespace isotouch::field {

/// The mean of the eight samples nearest to a brick's centre, weighted by 1 / (1 + d²), d their distances from it in voxels.
///
/// stiffness    of each sample, N/mm
/// samples      their tree, index coordinates
/// returns      one for each brick, within the range of the samples'; the same to the bit for any number of threads
/// source       inverse distance weighting: Shepard 1968, A two-dimensional interpolation function for irregularly-spaced data
std::vector<double> brick_stiffness(const std::vector<Brick>& bricks, const std::vector<double>& stiffness, const Nearest& samples);

}  // namespace isotouch::field
