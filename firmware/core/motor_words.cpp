#include "firmware/core/motor_words.h"

#include <algorithm>
#include <cstddef>
#include <cstdlib>

#include "shared/roots.h"

namespace isotouch::core {

namespace {

constexpr int kWordBits = 8;
constexpr int kPerTorqueBits = 20;

using Raw3 = std::array<std::int64_t, 3>;  // words with kWordBits, within 32 bits

/// Scales all three so that the largest is at the limit, if it is beyond.
bool scale_to(std::int64_t limit, Raw3& values) {
  const std::int64_t largest = std::max({std::abs(values[0]), std::abs(values[1]), std::abs(values[2])});
  if (largest <= limit) return false;
  const Reciprocal inverse = reciprocal(static_cast<std::uint64_t>(largest));
  const std::int64_t factor = (limit * inverse.mantissa) >> (inverse.shift - 30);  // below 1 with 30 fraction bits; limit below 2^28
  for (std::int64_t& value : values) value = round_shift(value * factor, 30);
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
  for (std::size_t i = 0; i < 3; ++i) change[i] = words[i] - std::int64_t{last[i]} * (1 << kWordBits);
  out.slew_limited = scale_to(motors.slew, change);
  for (std::size_t i = 0; i < 3; ++i) out.words[i] = static_cast<std::int16_t>(last[i] + round_shift(change[i], kWordBits));
  return out;
}

}  // namespace isotouch::core
