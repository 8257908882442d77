/// An even subset of many points on a surface.
#pragma once

#include <cstddef>
#include <vector>

#include "host/cloud/oriented_points.h"

namespace isotouch::cloud {

/// Removes the most crowded candidate again and again until `count` are left: a Poisson-disk set of exactly that size. Candidates whose normals
/// face away from each other do not crowd each other, so a thin part keeps points on both of its sides.
///
/// candidates  area-uniform, a few times `count` (5 to 10)
/// area        of the surface they lie on, in their units squared
/// returns     the indices kept, ascending; all of them when there are no more than `count`
/// source      weighted sample elimination: C. Yuksel, "Sample elimination for generating Poisson disk sample sets", Computer Graphics Forum
///             34(2), 2015, with its alpha = 8, beta = 0.65, gamma = 1.5
std::vector<std::size_t> spread_out(const OrientedPoints& candidates, double area, std::size_t count);

}  // namespace isotouch::cloud
