#include "firmware/core/motor_commands.h"

#include <cstddef>

#include "shared/roots.h"

namespace isotouch::core {

namespace {

constexpr int kCommandBits = 8;
constexpr int kPerTorqueBits = 20;

using Raw3 = std::array<std::int32_t, 3>;  // commands with kCommandBits

/// Absolute value; defined for INT32_MIN, where std::abs is not.
constexpr std::uint32_t absolute(std::int32_t value) {
  return value < 0 ? 0 - static_cast<std::uint32_t>(value) : static_cast<std::uint32_t>(value);
}

/// Scales all three so that the largest is at the limit, if it is beyond.
bool scale_to(std::int32_t limit, Raw3& values) {
  const std::uint32_t x = absolute(values[0]), y = absolute(values[1]), z = absolute(values[2]);
  const std::uint32_t larger = x > y ? x : y, largest = larger > z ? larger : z;
  if (largest <= static_cast<std::uint32_t>(limit)) return false;
  const Reciprocal inverse = reciprocal32(largest);
  const auto factor = static_cast<Narrow>(product(limit, inverse.mantissa) >> (inverse.shift - 30));  // below 1 with 30 fraction bits
  for (std::int32_t& value : values) value = static_cast<std::int32_t>(round_shift(product(value, factor), 30));
  return true;
}

}  // namespace

Motors make_motors(const DeviceModel& device, std::uint32_t period_ns) {
  Motors motors;
  const std::int64_t one = std::int64_t{1} << (kPerTorqueBits + NewtonMmPerWord::kFractionBits);
  motors.units_per_newton_mm = saturate32((one + device.word_torque.raw() / 2) / device.word_torque.raw());
  motors.limit = device.word_limit << kCommandBits;
  motors.slew = saturate32(std::int64_t{device.word_slew} * period_ns / 1'000'000 * (1 << kCommandBits) / 1'000);
  return motors;
}

Commanded motor_commands(const JointTorques& torques, const Motors& motors, const MotorCommands& last) {
  constexpr int kShift = NewtonMm::kFractionBits + kPerTorqueBits - kCommandBits;
  Raw3 wanted{};
  for (std::size_t i = 0; i < 3; ++i) {
    wanted[i] = saturate32(round_shift(-std::int64_t{torques[i].raw()} * motors.units_per_newton_mm, kShift));
  }
  Commanded out;
  out.limited = scale_to(motors.limit, wanted);
  Raw3 change{};
  for (std::size_t i = 0; i < 3; ++i) change[i] = wanted[i] - last[i] * (1 << kCommandBits);  // both below 2^24
  out.slew_limited = scale_to(motors.slew, change);
  for (std::size_t i = 0; i < 3; ++i) out.commands[i] = static_cast<std::int16_t>(last[i] + round_shift(change[i], kCommandBits));
  return out;
}

}  // namespace isotouch::core
