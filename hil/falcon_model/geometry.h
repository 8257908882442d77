/// The numbers that make a Falcon's mechanism, as settings: public sources disagree on them, so each published set is offered.
#pragma once

#include <array>

#include "hil/falcon_model/angle.h"

namespace isotouch::falcon_model {

inline constexpr int kLegs = 3;  ///< top, right, left as seen by the person in front

/// Five lengths enter the model of the legs, mm, and the azimuth of each leg's radial direction.
///
/// source    R. E. Stamper, A Three Degree of Freedom Parallel Manipulator with Only Translational Degrees of Freedom, 1997, chapter 3
struct Geometry {
  double upper_arm = 60;              ///< a
  double parallelogram = 102.5;       ///< b
  double offset_along = 2 * 11.25;    ///< d + e
  double offset_radial = 14.43 - 40;  ///< c - r
  double offset_tangential = -1.91;   ///< f - s
  std::array<double, kLegs> azimuth{radians(105), radians(-15), radians(-135)};
};

/// libnifalcon's numbers, since September 2009.
constexpr Geometry libnifalcon_geometry() { return {}; }

/// Martin and Hillier, Characterisation of the Novint Falcon haptic device for application as a robot manipulator, 2009, as implementations quote it.
constexpr Geometry martin_hillier_geometry() {
  return {60, 102.5, 2 * 11.5, 15.7 - 36.6, 27.2 - 26.2, {radians(105), radians(345), radians(225)}};
}

/// From motors and encoders to the arms.
struct Transmission {
  double counts_per_radian = 4 * 320 * (110 / 14.25) / (2 * kPi);                  ///< slots, quadrature, arm sector over shaft
  std::array<double, kLegs> angle_at_zero{radians(35), radians(35), radians(35)};  ///< of the arms at count 0
  double torque_per_unit_n_mm = 0.1;                                               ///< at the arm; a positive command pulls the arm inwards
  int largest_command = 4095;
  int stop_counts = 1600;  ///< the arm's mechanical ends, counted from count 0
};

constexpr Transmission libnifalcon_transmission() { return {}; }
constexpr Transmission martin_hillier_transmission() {
  return {4 * 320 * 7.62 / (2 * kPi), {radians(40), radians(40), radians(40)}, 0.15114, 4095, 1600};
}

}  // namespace isotouch::falcon_model
