/// A hand that holds the grip: a spring and a damper towards where it wants to be, so that the device's force moves it.
///
/// It homes first, pulling the grip fully out and pushing it fully in until all axes are homed, and does so again whenever homing is lost.
#pragma once

#include <optional>
#include <utility>

#include "hil/falcon_model/paths.h"

namespace isotouch::falcon_model {

struct HandSettings {
  double stiffness_n_per_mm = 0.5;
  double damping_n_s_per_m = 5;
  double largest_force_n = 25;
  Vector workspace_mm{0, 0, 125};  ///< the workspace's origin in the device frame
};

class Hand {
 public:
  /// path      what it does once the device is homed; none: nobody holds the grip
  Hand(const HandSettings& settings, Path path) : settings_(settings), path_(std::move(path)) {}

  /// Time goes on by `ms`. grip is where the hand holds it now, device frame, mm.
  void advance(double ms, const Vector& grip, bool homed);

  /// The force on a grip at this place with this velocity, N.
  Vector force_n(const Vector& position_mm, const Vector& velocity_mm_s) const;

  /// Where it wants to be, device frame, mm; nothing before the first advance.
  std::optional<Vector> target_mm() const { return target_; }
  bool follows_path() const { return phase_ == Phase::kFollow; }

 private:
  enum class Phase { kLetGo, kHome, kTravel, kFollow };
  void enter(Phase phase, const Vector& grip);
  Vector wanted() const;

  HandSettings settings_;
  Path path_;
  Phase phase_ = Phase::kLetGo;
  double time_ms_ = 0;  ///< since the phase began
  Vector from_;
  std::optional<Vector> target_;
  Vector speed_mm_s_;
};

}  // namespace isotouch::falcon_model
