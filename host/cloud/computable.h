/// Places that are too far away to compute with.
#pragma once

#include <Eigen/Core>

namespace isotouch::cloud {

/// Can distances to a place be computed, and their squares? What is farther away becomes infinite, or no number.
inline bool is_computable(const Eigen::Vector3d& place) { return (place.array().abs() <= 1e100).all(); }

}  // namespace isotouch::cloud
