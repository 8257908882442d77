/// From postures of known place to the angles of a device's arms at count 0.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "shared/device_model.h"

namespace isotouch::evaluate {

/// A hand that held still.
struct Posture {
  Eigen::Vector3d grip_mm;  ///< where the grip was, device frame: x right, y up, z towards the person, from the middle of the motor axes
  std::array<double, 3> counts;  ///< what the encoders said, legs 1 to 3
};

struct AngleCalibration {
  std::array<Angle, 3> at_zero;      ///< of the arms at count 0: the mean over all postures
  std::array<double, 3> turned_deg;  ///< from the model's
  double apart_deg = 0;              ///< how far two postures contradict each other at most
};

/// Lengths, ratios and azimuths are taken to be the model's.
///
/// postures  at least one
/// returns   nothing where the arms do not reach one of the places
std::optional<AngleCalibration> calibrate(const DeviceModel& model, const std::vector<Posture>& postures);

}  // namespace isotouch::evaluate
