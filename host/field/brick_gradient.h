/// How the distance changes at a sample of a brick.
#pragma once

#include <Eigen/Core>
#include <cstddef>

#include "host/field/band_field.h"

namespace isotouch::field {

/// Differences to the neighbours within the brick, voxels a voxel; outward of the surface, where the sample lies near it.
///
/// sample    0 to 63
inline Eigen::Vector3d gradient_at(const Brick& brick, int sample) {
  Eigen::Vector3d gradient;
  for (int axis = 0; axis < 3; ++axis) {
    const int step = 1 << (2 * axis), index = sample / step & 3;
    const int before = index > 0 ? 1 : 0, after = index < 3 ? 1 : 0;
    const auto at = [&](int s) { return static_cast<double>(brick.distance[static_cast<std::size_t>(s)]); };
    gradient[axis] = (at(sample + after * step) - at(sample - before * step)) / (before + after);
  }
  return gradient;
}

}  // namespace isotouch::field
