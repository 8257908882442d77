/// The packets that a device sends while a recorded hand moves it: from HIP positions to encoder counts, by the model's inverse kinematics.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <optional>

#include "shared/device_io.h"
#include "shared/device_model.h"

namespace isotouch::evaluate {

/// Arm angles in encoder counts, not rounded; elbows out.
///
/// grip      device frame, mm
/// returns   nothing where the arms do not reach
/// source    R. E. Stamper 1997, chapter 3: θ = atan2(z, A) - acos((ρ² + a² - E²) / (2aρ))
std::optional<std::array<double, 3>> counts_at(const Eigen::Vector3d& grip, const DeviceModel& model);

/// A homed device in a hand.
class WireHand {
 public:
  explicit WireHand(const DeviceModel& model) : model_(model) {}
  /// The device's packet at this place of the hand, with the nearest counts; fresh, age and buttons are the hand's. Out of reach, the last place is kept.
  ///
  /// generation   of the field that is loaded
  DeviceInput operator()(const TickInput& hand, std::uint32_t generation);
  /// Packets whose place was out of reach.
  std::uint64_t out_of_reach() const { return out_of_reach_; }

 private:
  DeviceModel model_;
  FalconReply reply_;
  std::uint64_t out_of_reach_ = 0;
};

}  // namespace isotouch::evaluate
