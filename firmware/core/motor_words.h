/// Arm torques → motor words, within what the motors take.
#pragma once

#include <array>
#include <cstdint>

#include "firmware/core/joint_torques.h"
#include "shared/device_model.h"

namespace isotouch::core {

/// See `make_motors`.
struct Motors {
  std::int32_t words_per_newton_mm = 0;  ///< 1 / k, 20 fraction bits
  std::int32_t limit = 0;                ///< words, 8 fraction bits
  std::int32_t slew = 0;                 ///< words a tick, 8 fraction bits
};

/// tick      no: divides
Motors make_motors(const DeviceModel& device, std::uint32_t period_ns);

struct MotorWords {
  std::array<std::int16_t, 3> words{};
  bool limited = false;       ///< all three were shortened by one factor so that the largest is at the limit
  bool slew_limited = false;  ///< the change since the last words was shortened by one factor
};

/// u = -τ / k: a positive word turns the arm inwards. Too large words and too large changes are scaled together, so that the direction is kept.
///
/// last      the words of the last tick; zero after rest
/// returns   within 1 word of the exact ones
/// fails     never
/// tick      yes
MotorWords motor_words(const JointTorques& torques, const Motors& motors, const std::array<std::int16_t, 3>& last);

}  // namespace isotouch::core
