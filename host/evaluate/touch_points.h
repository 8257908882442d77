/// What a recorded hand felt → oriented points: a trace of positions and forces is a scan of what was touched.
#pragma once

#include <cstddef>
#include <cstdint>

#include "host/cloud/oriented_points.h"
#include "host/trace/trace_file.h"
#include "shared/trace.h"

namespace isotouch::evaluate {

/// What a tick says of a surface.
enum class TouchKind {
  kFree,   ///< nothing is touched
  kUnfit,  ///< ramping, limited, following, held inside, clamped, or with an old sample: the force tells no depth
  kWeak,   ///< less than the least force
  kTouch,
};
TouchKind touch_kind(const TraceRecord& record, double least_force_n);

struct TouchOptions {
  double stiffness_n_per_mm = 0;  ///< of the wall that was felt; 0 = the trace's
  double least_force_n = 0.05;    ///< weaker touches have no direction worth keeping
  std::size_t points = 4000;      ///< at most so many; fewer where less was touched
};

/// What became of the ticks, and of the touches.
struct TouchReport {
  std::size_t ticks = 0;
  std::size_t free = 0;
  std::size_t unfit = 0;
  std::size_t weak = 0;
  std::size_t touches = 0;  ///< the others
  std::size_t places = 0;   ///< after averaging what lies within a quarter of the spacing, by side
  std::size_t points = 0;   ///< after thinning
  double spacing_mm = 0;    ///< what the points' number gives on the area that was touched
};

/// A touch is one tick: the surface lies at HIP + force / stiffness, its normal is the force's direction. Touches of one place and side are
/// averaged, then an even subset of the places is kept (elimination.h).
///
/// returns   workspace, mm
/// fails     InputError: no outputs in the trace, encoder counts, no stiffness, damping (then the force is no measure of depth), nothing touched
/// source    Sreeni, "Distance Field based Haptic Rendering of Scattered Oriented Points", section 4
cloud::OrientedPoints touch_points(const trace::Trace& trace, const TouchOptions& options, TouchReport& report);

/// The second half alone: averages and thins; `report` gets places, points and spacing.
cloud::OrientedPoints thinned(const cloud::OrientedPoints& touches, std::size_t points, TouchReport& report);

}  // namespace isotouch::evaluate
