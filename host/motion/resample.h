/// Motion at uneven times → motion at the tick's.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "host/motion/motion_csv.h"
#include "shared/tick_io.h"

namespace isotouch::motion {

inline constexpr double kMaxMm = 2047;  ///< that a trace holds, on each axis

/// s, between two samples of a hand that felt forces: at 10 Hz it cannot be followed anyway.
inline constexpr double kMaxGap = 0.1;

/// One position a tick from the first sample's time to the last's: a cubic between neighbours whose velocity is continuous and which, along
/// each axis, stays between them: it passes through every sample and invents neither overshoot at a stop nor motion in a pause.
///
/// points    at least two, time rising
/// emit      takes the ticks in their order; forces run straight between neighbours, so that none is stronger than what was recorded. Between two that are
///           more than kMaxGap apart, no force is known
/// returns   the number of ticks
/// fails     InputError: a position beyond ±2047 mm, more than 10^8 ticks
/// source    monotone piecewise cubic interpolation: Fritsch and Butland, SIAM J. Sci. Stat. Comput. 5(2), 1984
std::uint64_t resample(const std::vector<TimedPoint>& points, std::uint32_t period_ns,
                       const std::function<void(const Input&, const std::optional<Eigen::Vector3d>& force)>& emit);

}  // namespace isotouch::motion
