/// What a recorded hand felt → oriented points: a trace of positions and forces is a scan of what was touched.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <string>

#include "host/cloud/oriented_points.h"
#include "host/trace/trace_file.h"
#include "shared/trace.h"

namespace isotouch::evaluate {

/// What a tick says of a surface.
enum class TouchKind {
  kFree,   ///< nothing is touched
  kUnfit,  ///< ramping, limited, following, held inside, clamped, with an old sample, or without a proxy: it shows no surface
  kWeak,   ///< less than the least force
  kTouch,
};

struct Touch {
  Eigen::Vector3d position, normal;  ///< of the surface: workspace, mm; unit, outward
};

/// Reads the ticks of one hand, in their order. The surface lies at the proxy, and the way there from the hand is its normal. Forces do not say that:
/// dampings and the handle's weight are in them, and a surface may be soft in places.
class TouchReader {
 public:
  /// name      of the recording, or of the controller
  /// settings  that hold before the first tick
  /// wall      N/mm, of the wall whose forces another device measured without a proxy: the surface lies at HIP + force / wall. 0: not known
  /// fails     InputError: there is friction, which moves the proxy along the surface
  TouchReader(std::string name, const TickSettings& settings, double least_force_n, double wall = 0);

  /// touch     gets what a kTouch shows
  /// fails     InputError: friction is set in this tick; another field is touched than before, and it is not the same one, patched
  TouchKind read(const TraceRecord& record, Touch& touch);

  /// These settings hold now: changes in lost ticks were not seen.
  ///
  /// fails     InputError: there is friction
  void set(const TickSettings& settings);

  /// Touches without a proxy. If `wall` is not known, they are unfit.
  std::size_t proxyless() const { return proxyless_; }
  /// Why the ticks until now show no surface: they have forces and no proxies.
  ///
  /// fails     InputError: always
  [[noreturn]] void refuse_proxyless() const;

 private:
  void require_no_friction() const;
  void follow_field(const Input& input);

  std::string name_;
  TickSettings settings_;
  double least_force_n_, wall_;
  std::size_t proxyless_ = 0;
  std::uint32_t generation_ = 0;  ///< of the field that was loaded last; 0: none
  bool has_touched_ = false;
  bool is_another_ = false;  ///< the field that is loaded, than the one that was touched
};

struct TouchOptions {
  double stiffness_n_per_mm = 0;  ///< of the wall, where the trace has forces and no proxies; 0 = not known
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

/// A touch is one tick. Touches of one place and side are averaged, then an even subset of the places is kept (host/cloud/poisson_disk.h).
///
/// returns   workspace, mm
/// fails     InputError: no outputs in the trace, friction, two fields, no proxies and no stiffness, a stiffness beside proxies, nothing touched
/// source    Sreeni, "Distance Field based Haptic Rendering of Scattered Oriented Points", section 4
cloud::OrientedPoints touch_points(const trace::Trace& trace, const TouchOptions& options, TouchReport& report);

/// The second half alone: averages and thins; `report` gets places, points and spacing.
cloud::OrientedPoints thinned(const cloud::OrientedPoints& touches, std::size_t points, TouchReport& report);

}  // namespace isotouch::evaluate
