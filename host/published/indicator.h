/// Which nodes are inside: those in any packing sphere.
#pragma once

#include <vector>

#include "host/cloud/oriented_points.h"
#include "host/field/progress.h"
#include "host/published/level_field.h"

namespace isotouch::published {

/// points    any unit that the grid has too; unit outward normals
/// radii     packing radii, one a point. A point with an infinite one gives no sphere: the paper defines the radius as a minimum over the
///           partners below the tangent plane, and there is none; the half-space that it would be in the limit would flood the grid
/// returns   1 at nodes within a sphere or on it, else 0. Spheres are cut at the grid's border
/// fails     never
/// source    Sreeni, 3.1: "Indicator"
Indicator nodes_in_spheres(const cloud::OrientedPoints& points, const std::vector<double>& radii, const field::Grid& grid,
                           field::Progress& progress);

}  // namespace isotouch::published
