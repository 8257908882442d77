#include "hil/falcon_model/mechanism.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace isotouch::falcon_model {

namespace {

/// Of what an arm is beyond its end, so much is taken back in each sub-step.
constexpr double kReturn = 0.2;

double counts_of(const Legs& legs, std::size_t i, const Transmission& t) {
  return (legs[i].angle() - t.angle_at_zero[i]) * t.counts_per_radian;
}

}  // namespace

Mechanism::Mechanism(const MechanismSettings& settings)
    : settings_(settings), kinematics_(settings.geometry), position_(settings.start_mm) {
  if (!(settings.mass_kg > 0)) throw std::invalid_argument("the grip's mass must be positive");
  if (settings.sub_steps_per_ms < 1) throw std::invalid_argument("a millisecond takes at least one sub-step");
  const auto legs = kinematics_.legs(position_);
  if (!legs) throw std::invalid_argument("the arms do not reach the grip's place at the start");
  legs_ = *legs;
}

Counts Mechanism::counts() const {
  Counts counts{};
  for (std::size_t i = 0; i < kLegs; ++i) counts[i] = static_cast<int>(std::floor(counts_of(legs_, i, settings_.transmission)));
  return counts;
}

Vector Mechanism::motor_force_n(const Commands& commands) const {
  const Transmission& t = settings_.transmission;
  Torques torques{};
  for (std::size_t i = 0; i < kLegs; ++i) {
    torques[i] = -t.torque_per_unit_n_mm * std::clamp(commands[i], -t.largest_command, t.largest_command);
  }
  return force_of(legs_, torques);
}

void Mechanism::sub_step(const Vector& force_n) {
  const double dt = 0.001 / settings_.sub_steps_per_ms;
  const Vector total = force_n + settings_.gravity_n - settings_.damping_n_s_per_m / 1000 * velocity_;
  velocity_ = velocity_ + 1000 * dt / settings_.mass_kg * total;  // N/kg are 1000 mm/s²
  const Vector back = stop_at_the_ends();
  const Vector next = position_ + dt * velocity_ + back;
  const auto legs = kinematics_.legs(next);
  if (!legs) {  // stretched beyond what the arms reach
    velocity_ = {};
    return;
  }
  position_ = next;
  legs_ = *legs;
}

/// An arm goes no further than its end: what speed would carry it beyond is lost. What a slide along the end drifts beyond is led back;
/// returns the move that does so.
Vector Mechanism::stop_at_the_ends() {
  const Transmission& t = settings_.transmission;
  const double dt = 0.001 / settings_.sub_steps_per_ms;
  const double stop = t.stop_counts / t.counts_per_radian;
  Vector back;
  for (std::size_t i = 0; i < legs_.size(); ++i) {
    const Leg& leg = legs_[i];
    const double angle = leg.angle() - t.angle_at_zero[i];
    const Vector& row = leg.angle_per_mm;
    const Vector per_radian = 1 / dot(row, row) * row;  // the shortest move that turns this arm
    const double speed = dot(row, velocity_);
    const double side = angle < 0 ? -1 : 1;
    const double room = stop - side * angle;  // rad
    const double fastest = std::max(0.0, room) / dt;
    if (side * speed > fastest) velocity_ = velocity_ - (speed - side * fastest) * per_radian;
    if (room < 0) back = back + kReturn * side * room * per_radian;
  }
  return back;
}

}  // namespace isotouch::falcon_model
