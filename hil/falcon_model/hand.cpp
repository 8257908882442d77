#include "hil/falcon_model/hand.h"

#include <algorithm>
#include <cmath>

#include "hil/falcon_model/smooth.h"

namespace isotouch::falcon_model {

namespace {

constexpr Vector kOut{0, 0, 178}, kIn{0, 0, 76};  // device frame, just inside the arms' ends
constexpr double kStrokeMs = 900;                 // fully out or fully in
constexpr double kTravelMs = 600;

}  // namespace

void Hand::enter(Phase phase, const Vector& grip) {
  phase_ = phase;
  time_ms_ = 0;
  from_ = grip;
}

Vector Hand::wanted() const {
  switch (phase_) {
    case Phase::kHome: {  // from the first place out, then in, out, in ...
      const double strokes = std::floor(time_ms_ / kStrokeMs);
      const bool outward = std::fmod(strokes, 2) == 0;
      const Vector begin = strokes == 0 ? from_ : outward ? kIn : kOut;
      const Vector end = outward ? kOut : kIn;
      return begin + smooth(time_ms_ / kStrokeMs - strokes) * (end - begin);
    }
    case Phase::kTravel: return from_ + smooth(time_ms_ / kTravelMs) * (settings_.workspace_mm + path_(0) - from_);
    default: return settings_.workspace_mm + path_(time_ms_);
  }
}

void Hand::advance(double ms, const Vector& grip, bool homed) {
  if (!path_) return;
  if (phase_ == Phase::kLetGo || (phase_ != Phase::kHome && !homed)) {
    enter(Phase::kHome, grip);
  } else if (phase_ == Phase::kHome && homed) {
    enter(Phase::kTravel, *target_);
  } else if (phase_ == Phase::kTravel && time_ms_ >= kTravelMs) {
    enter(Phase::kFollow, grip);
  }
  const Vector before = target_.value_or(wanted());
  time_ms_ += ms;
  target_ = wanted();
  speed_mm_s_ = 1000 / ms * (*target_ - before);
}

Vector Hand::force_n(const Vector& position_mm, const Vector& velocity_mm_s) const {
  if (!target_) return {};
  const Vector force =
      settings_.stiffness_n_per_mm * (*target_ - position_mm) + settings_.damping_n_s_per_m / 1000 * (speed_mm_s_ - velocity_mm_s);
  const double size = length(force);
  return size > settings_.largest_force_n ? settings_.largest_force_n / size * force : force;
}

}  // namespace isotouch::falcon_model
