/// A known distance on a grid: the floor that every method is measured against, and the field of the benchmarks.
#pragma once

#include <Eigen/Core>
#include <functional>

#include "host/field/band_field.h"

namespace isotouch::field {

/// distance   workspace point, mm → signed distance, mm, negative inside; may change by at most 1 mm a mm, as every true distance does
/// grid       the surface stays clear of its two outermost layers of samples
/// band       voxels
/// returns    distances in voxels, all of them true, also those beyond the band
/// fails      never
BandField sample_distance(const std::function<double(const Eigen::Vector3d&)>& distance, const Grid& grid, double band);

}  // namespace isotouch::field
