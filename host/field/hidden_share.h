/// Can all points of a scan have been seen from one place?
#pragma once

#include <Eigen/Core>

#include "host/field/scan.h"

namespace isotouch::field {

/// A sample is hidden when of those that lie in nearly the same direction from the eye many are nearer to it, and in front of the sample's tangent
/// plane. What one sensor sees has hardly any, at the edges of its shadows; of a whole body half of the samples are hidden.
///
/// eye       away from the samples, the scan's unit
/// returns   the share of the samples that are hidden
double hidden_share(const Scan& scan, const Eigen::Vector3d& eye);

}  // namespace isotouch::field
