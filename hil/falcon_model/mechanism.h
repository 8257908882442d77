/// The mechanism that is moved: arms, motors and grip as one mass at the grip, integrated by itself in doubles.
///
/// Assumptions, for want of a device to measure: apparent mass the same in every direction, viscous damping at the grip, stops that give nothing back,
/// no back-EMF and no friction. Semi-implicit Euler: velocity first, then position with the new velocity.
#pragma once

#include <array>

#include "hil/falcon_model/kinematics.h"

namespace isotouch::falcon_model {

struct MechanismSettings {
  Geometry geometry;
  Transmission transmission;
  double mass_kg = 0.3;
  double damping_n_s_per_m = 3;
  Vector gravity_n{0, -0.8, 0};
  Vector start_mm{0, 0, 110};
  int sub_steps_per_ms = 8;
};

using Commands = std::array<int, kLegs>;  ///< motor units: top, right, left
using Counts = std::array<int, kLegs>;    ///< encoder counts from the reference angle

class Mechanism {
 public:
  /// fails     std::invalid_argument when no arms reach settings.start_mm, or a mass or a number of sub-steps is not positive
  explicit Mechanism(const MechanismSettings& settings);

  Vector position_mm() const { return position_; }
  Vector velocity_mm_s() const { return velocity_; }
  const Legs& legs() const { return legs_; }
  const Kinematics& kinematics() const { return kinematics_; }

  /// The arms' angles in whole counts, rounded down, unlimited and without any zero but the reference angle's.
  Counts counts() const;

  /// The force of motor commands, clamped to what the motors take, on the grip, N.
  Vector motor_force_n(const Commands& commands) const;

  /// Moves on by `ms`; `push(position mm, velocity mm/s)` gives the hand's force, N, and is asked at every sub-step.
  template <class Push>
  void step(double ms, const Commands& commands, Push push) {
    const int steps = static_cast<int>(ms * settings_.sub_steps_per_ms + 0.5);
    for (int i = 0; i < steps; ++i) sub_step(motor_force_n(commands) + push(position_, velocity_));
  }

 private:
  void sub_step(const Vector& force_n);
  Vector stop_at_the_ends();

  MechanismSettings settings_;
  Kinematics kinematics_;
  Vector position_;
  Vector velocity_;
  Legs legs_;
};

}  // namespace isotouch::falcon_model
