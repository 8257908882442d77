/// Where the grip is, and which force motor commands make there: in doubles, and apart from the tick's own kinematics, so that a mistake in one of the two
/// shows.
///
/// source    R. E. Stamper, A three degree of freedom parallel manipulator with only translational degrees of freedom, 1997, chapter 3
/// tick      no: it runs beside the tick. It does not allocate
#pragma once

#include <array>
#include <cstdint>

#include "shared/device_model.h"

namespace isotouch::guard {

using Point = std::array<double, 3>;

double length(const Point& v);
double dot(const Point& a, const Point& b);
Point operator-(const Point& a, const Point& b);

/// A grip that was found.
struct Grip {
  Point at{};                    ///< HIP, mm, workspace frame
  std::array<Point, 3> turns{};  ///< how each arm turns with the HIP, rad/mm
};

class ArmGeometry {
 public:
  explicit ArmGeometry(const DeviceModel& device);

  /// Solves the closures of the three legs.
  ///
  /// counts    of the encoders
  /// near      where it looks first, mm, workspace frame; then it looks from the middle, from where every place of the workspace is found
  /// grip      changed only where it was found
  /// returns   found, to 1 µm; false: no place that the arms reach, the elbows point inwards, or a singularity lies between it and the workspace's middle
  bool find(const std::array<std::int16_t, 3>& counts, const Point& near, Grip& grip) const;

  /// By the principle of virtual work: the sum of each arm's torque times how it turns.
  ///
  /// returns   N, on the hand, device axes
  Point force(const std::array<std::int16_t, 3>& commands, const Grip& grip) const;

  /// The most that commands which are a unit off change the force by, N: little in the middle, much where an elbow is nearly stretched.
  double rounding(const Grip& grip) const;

 private:
  bool find_from(const Point& near, const std::array<std::int16_t, 3>& counts, Grip& grip) const;

  struct Leg {
    Point outwards, across;     // unit vectors: along the leg's azimuth, and across it
    double at_zero, per_count;  // rad
  };

  std::array<Leg, 3> legs_{};
  bool clockwise_ = false;                          // the legs follow each other from y towards x
  double arm_, rod_, joint_, radial_, tangential_;  // mm
  double torque_;                                   // N mm, of one unit of a command
  Point origin_{};                                  // of the workspace, mm, device frame
};

}  // namespace isotouch::guard
