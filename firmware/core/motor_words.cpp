#include "firmware/core/motor_words.h"

#include <cstddef>

#include "shared/roots.h"

namespace isotouch::core {

namespace {

constexpr int kWordBits = 8;
constexpr int kPerTorqueBits = 20;

using Raw3 = std::array<std::int32_t, 3>;  // words with kWordBits

/// Its size, without a number that has none.
constexpr std::uint32_t size_of(std::int32_t value) {
  return value < 0 ? 0 - static_cast<std::uint32_t>(value) : static_cast<std::uint32_t>(value);
}

/// Scales all three so that the largest is at the limit, if it is beyond.
bool scale_to(std::int32_t limit, Raw3& values) {
  const std::uint32_t x = size_of(values[0]), y = size_of(values[1]), z = size_of(values[2]);
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
  motors.words_per_newton_mm = saturate32((one + device.word_torque.raw() / 2) / device.word_torque.raw());
  motors.limit = device.word_limit << kWordBits;
  motors.slew = saturate32(std::int64_t{device.word_slew} * period_ns / 1'000'000 * (1 << kWordBits) / 1'000);
  return motors;
}

MotorWords motor_words(const JointTorques& torques, const Motors& motors, const std::array<std::int16_t, 3>& last) {
  constexpr int kShift = NewtonMm::kFractionBits + kPerTorqueBits - kWordBits;
  Raw3 words{};
  for (std::size_t i = 0; i < 3; ++i) {
    words[i] = saturate32(round_shift(-std::int64_t{torques[i].raw()} * motors.words_per_newton_mm, kShift));
  }
  MotorWords out;
  out.limited = scale_to(motors.limit, words);
  Raw3 change{};
  for (std::size_t i = 0; i < 3; ++i) change[i] = words[i] - last[i] * (1 << kWordBits);  // both below 2^24
  out.slew_limited = scale_to(motors.slew, change);
  for (std::size_t i = 0; i < 3; ++i) out.words[i] = static_cast<std::int16_t>(last[i] + round_shift(change[i], kWordBits));
  return out;
}

}  // namespace isotouch::core
