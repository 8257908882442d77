/// The angle between two directions.
#pragma once

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

namespace isotouch {

/// returns   degrees, 0 to 180, exact to rounding for small angles, too; vectors of any length, 0 where one of them has none
inline double angle_deg(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
  return std::atan2(a.cross(b).norm(), a.dot(b)) * 180 / std::numbers::pi;
}

}  // namespace isotouch
