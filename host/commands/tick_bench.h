/// Times of single ticks on a motion, HIP to force.
///
/// Each tick is timed by itself, between two readings of the steady clock: a mean over many ticks would hide just the slow ones that p99.9 asks for.
/// What two readings cost without a tick between them is measured in the same run and taken off. The whole motion is walked once before it is
/// timed, so that caches and branch predictors are warm; only ticks in contact count.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <vector>

#include "host/published/level_field.h"
#include "shared/blob.h"

namespace isotouch::commands {

struct TickTimes {
  double median_ns = 0;
  double p99_ns = 0;
  double p999_ns = 0;
  std::size_t ticks = 0;  ///< in contact
};

/// HIP positions a millisecond apart, workspace, mm.
using Motion = std::vector<Eigen::Vector3d>;

/// The core's tick on a blob.
///
/// fails     InputError when the motion never touches the object
TickTimes time_core(const BlobView& field, const Motion& motion);

/// The published single-precision tick on its levels.
///
/// stiffness N/mm
/// fails     InputError when the motion never touches the object
TickTimes time_published(const published::LevelField& levels, double stiffness, const Motion& motion);

}  // namespace isotouch::commands
