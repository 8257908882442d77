/// The three legs: where the grip is, how far each arm has turned, and how one changes with the other. Written from the device's sheet alone.
///
/// source    Stamper 1997, chapters 3 and 4; the elbow is always out
#pragma once

#include <array>
#include <optional>

#include "hil/falcon_model/geometry.h"
#include "hil/falcon_model/vector.h"

namespace isotouch::falcon_model {

/// One leg, for a grip position: the arm's angle as a direction, and what a small move of the grip does to it.
struct Leg {
  double cos_angle = 0, sin_angle = 0;
  Vector angle_per_mm;  ///< row of the Jacobian, rad/mm

  double angle() const { return arc_tangent(sin_angle, cos_angle); }
};

using Legs = std::array<Leg, kLegs>;
using Angles = std::array<double, kLegs>;   ///< rad
using Torques = std::array<double, kLegs>;  ///< N·mm at the arms

class Kinematics {
 public:
  explicit Kinematics(const Geometry& geometry);

  /// The legs for a grip position, mm; nothing where no position of the arms reaches it.
  std::optional<Legs> legs(const Vector& grip) const;

  /// The grip position for three angles, by Newton's method from `near`; nothing when it does not converge to 1e-9 mm in 40 steps.
  std::optional<Vector> grip(const Angles& angles, const Vector& near = {0, 0, 110}) const;

 private:
  struct Axis {
    Vector radial, tangential;
  };
  Geometry geometry_;
  std::array<Axis, kLegs> axes_;
};

/// The force that torques on the arms give at the grip, N: the Jacobian's transpose.
Vector force_of(const Legs& legs, const Torques& torques);

/// The torques that give a force, N·mm; nothing where the Jacobian is singular.
std::optional<Torques> torques_of(const Legs& legs, const Vector& force);

}  // namespace isotouch::falcon_model
