/// The place of a triangle nearest to a point.
#pragma once

#include <Eigen/Core>
#include <array>

namespace isotouch::field {

/// A place on a triangle, and what of the triangle it lies on: 0 to 2 a corner, 3 to 5 an edge (corner 0 to 1, 1 to 2, 2 to 0), 6 the inside.
struct OnTriangle {
  Eigen::Vector3d point;
  int feature;
};

using Corners = std::array<Eigen::Vector3d, 3>;

/// source    C. Ericson, Real-Time Collision Detection, 2005, section 5.1.5
OnTriangle nearest_on_triangle(const Eigen::Vector3d& point, const Corners& triangle);

}  // namespace isotouch::field
