/// The values of one brick of a live field, from the samples near it.
#pragma once

#include <Eigen/Core>

#include "host/encoding/brick_tree.h"
#include "host/encoding/spline.h"
#include "host/live/live_model.h"
#include "host/live/near_samples.h"

namespace isotouch::live {

struct BrickValue {
  encoding::BrickKind kind = encoding::BrickKind::kOutside;
  encoding::Coefficients values{};  ///< of a stored one
  float influence = 0.0F;           ///< squared, from the brick's middle: a sample beyond that would not change this
};

/// first     index coordinates of its first place
/// size      of the grid: the body ends at the third layer from its border
/// near      what was chosen for this brick
/// returns   distances, rounded to 1/4096 voxel and clamped to ±band, and the kind that they make
BrickValue brick_value(const Eigen::Vector3i& first, const Eigen::Vector3i& size, const Reach& reach, NearSamples& near);

}  // namespace isotouch::live
