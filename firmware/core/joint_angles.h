/// Encoder counts → arm angles.
#pragma once

#include <array>
#include <cstdint>

#include "shared/angle.h"
#include "shared/device_model.h"

namespace isotouch::core {

using Counts = std::array<std::int16_t, 3>;
using JointAngles = std::array<Angle, 3>;  ///< of the arms against the plane of the motor axes, legs 1 to 3

/// The angle of each arm: its own offset and ratio times its count, to within half a unit of Angle.
///
/// tick      yes: one product a leg, at most 2^15 * 2^31
inline JointAngles joint_angles(const Counts& counts, const DeviceModel& device) {
  JointAngles angles;
  for (std::size_t i = 0; i < angles.size(); ++i) {
    const DeviceLeg& leg = device.legs[i];
    const std::int64_t turned = round_shift(std::int64_t{leg.per_count.raw()} * counts[i], AnglePerCount::kFractionBits);
    angles[i] = leg.at_zero + Angle::from_raw(static_cast<std::uint32_t>(turned));  // wraps where angles do
  }
  return angles;
}

}  // namespace isotouch::core
