/// Distances beside surface that was taken away: what lay nearest to it lies nearest to something else now.
#pragma once

#include <vector>

#include "host/field/band_field.h"
#include "host/field/brick_mask.h"

namespace isotouch::field {

/// Gives the taken samples, and those whose nearest surface was theirs, the distance to the surface that remains: from the shortest way over steps
/// to the 26 samples around each, between 8 % too small and a twentieth of a voxel too large. A sample with a neighbour across the remaining surface
/// keeps its distance.
///
/// field     bricks sorted by cell; the taken samples have the sign of their surroundings already, their magnitude does not count
/// taken     the samples of each brick
/// source    steps of 1, √2 and √3: Borgefors, Distance transformations in digital images, 1986; in the order of Dijkstra, 1959
void restore_distances(BandField& field, const std::vector<BrickMask>& taken);

}  // namespace isotouch::field
