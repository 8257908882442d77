/// A known distance on a grid: what the grid itself can hold, the floor under every method's error.
#pragma once

#include <Eigen/Core>
#include <functional>

#include "host/field/band_field.h"

namespace isotouch::evaluate {

/// grid       its border lies outside the object by more than the band
/// band       half width, voxels
/// distance   workspace, mm → mm, negative inside; never larger in magnitude than the Euclidean distance, and equal to it in the band
/// fails      never
field::BandField exact_field(const field::Grid& grid, double band, const std::function<double(const Eigen::Vector3d&)>& distance);

}  // namespace isotouch::evaluate
