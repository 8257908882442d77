/// The packets that a device sends while a recorded hand moves it: from HIP positions to encoder counts, by the model's inverse kinematics.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <optional>

#include "shared/device_model.h"
#include "shared/tick_io.h"

namespace isotouch::motion {

/// Arm angles in encoder counts, not rounded; elbows out.
///
/// grip      device frame, mm
/// returns   nothing where the arms do not reach
/// source    R. E. Stamper 1997, chapter 3: θ = atan2(z, A) - acos((ρ² + a² - E²) / (2aρ))
std::optional<std::array<double, 3>> counts_at(const Eigen::Vector3d& grip, const DeviceModel& model);

/// A homed device in a hand.
class DeviceInHand {
 public:
  explicit DeviceInHand(const DeviceModel& model) : model_(model) {}
  /// The device's packet at this place of the hand, with the nearest counts; fresh, age, buttons and the field's generation are the hand's. Out of reach, the last place is kept.
  Input operator()(const Input& hand);
  /// Packets whose place was out of reach.
  std::uint64_t out_of_reach() const { return out_of_reach_; }

 private:
  DeviceModel model_;
  FalconReply reply_;
  std::uint64_t out_of_reach_ = 0;
};

}  // namespace isotouch::motion
