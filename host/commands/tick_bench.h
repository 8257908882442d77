/// Times of single ticks on a motion, HIP to force or counts to motor commands.
///
/// Each tick is timed by itself, between two readings of the steady clock: a mean over many ticks would hide just the slow ones that p99.9 asks for.
/// What two readings cost without a tick between them is measured in the same run and taken off. Only ticks in contact count. With warm caches the
/// whole motion is walked once before it is timed, so that caches and branch predictors know it. With cold caches evicted_bytes() are written before each
/// tick: what the tick needs then comes from main memory, as on a board whose other programs used the caches in the meantime.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <vector>

#include "host/published/level_field.h"
#include "shared/field_view.h"
#include "shared/tick_io.h"

namespace isotouch::commands {

struct TickTimes {
  double median_ns = 0;
  double p99_ns = 0;
  double p999_ns = 0;
  std::size_t ticks = 0;  ///< in contact
};

enum class Caches { kWarm, kCold };

/// Written before each tick with cold caches: 64 MiB, or a quarter more than the processor's last cache holds where that is more.
std::size_t evicted_bytes();

/// HIP positions a millisecond apart, workspace, mm.
using Motion = std::vector<Eigen::Vector3d>;

/// Everything on that there is to feel: friction, dampings, passivity, weight.
TickSettings every_feature();

/// The core's tick on a field, HIP to force.
///
/// fails     InputError when the motion never touches the object
TickTimes time_core(const FieldView& field, const Motion& motion, const TickSettings& settings = {}, Caches caches = Caches::kWarm);

/// The device's tick, from its packet's counts to motor commands.
///
/// fails     InputError when the motion never touches the object within the device's reach
TickTimes time_device(const FieldView& field, const Motion& motion, const TickSettings& settings = {}, Caches caches = Caches::kWarm);

/// The published single-precision tick on its levels.
///
/// stiffness N/mm
/// fails     InputError when the motion never touches the object
TickTimes time_published(const published::LevelField& levels, double stiffness, const Motion& motion);

}  // namespace isotouch::commands
