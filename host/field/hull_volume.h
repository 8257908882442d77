/// How large the convex hull of some points is.
#pragma once

#include <Eigen/Core>
#include <vector>

namespace isotouch::field {

/// Volume of the intersection of 196 half spaces that hold all points, one for each of `half_directions` and its opposite: a little more than the
/// convex hull's. Counted in cells, 40 along each side of the points' box.
///
/// points    at least one
/// returns   their unit cubed; 0 where they lie in a plane of the axes
double hull_volume(const std::vector<Eigen::Vector3d>& points);

}  // namespace isotouch::field
