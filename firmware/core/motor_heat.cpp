#include "firmware/core/motor_heat.h"

#include <algorithm>
#include <limits>

#include "shared/fixed.h"

namespace isotouch::core {

namespace {
constexpr int kCommandBits = 8, kSquareBits = 16, kInputBits = 8, kQuarterBits = 40, kPartBits = 30;

std::int64_t warmest(const MotorHeat& heat) { return std::max({heat.squares[0], heat.squares[1], heat.squares[2]}); }

}  // namespace

HeatBudget make_heat_budget(const DeviceModel& device, std::uint32_t period_ns) {
  HeatBudget budget;
  if (device.heat_word == 0) {  // nobody watches
    budget.knee = std::numeric_limits<std::int64_t>::max();
    return budget;
  }
  const std::int64_t whole = std::int64_t{device.heat_word} * device.heat_word;  // below 2^24
  budget.quarter = std::max(whole / 4, std::int64_t{1});
  budget.of_quarter = (std::int64_t{1} << kQuarterBits) / budget.quarter;
  budget.knee = (whole - budget.quarter) << kSquareBits;
  budget.fall = std::int64_t{std::max<std::int32_t>(device.word_limit - device.heat_word, 0)} << kCommandBits;
  budget.forgotten = std::int64_t{period_ns} * (std::int64_t{1} << kPartBits) / (std::int64_t{device.heat_ms} * 1'000'000);  // below 2^23
  return budget;
}

std::uint32_t heat_input(const MotorHeat& heat) {
  if (!heat.has_begun) return 0;
  constexpr std::int64_t kPart = std::int64_t{1} << (kSquareBits - kInputBits);
  const std::int64_t most = std::min(warmest(heat), std::int64_t{UINT32_MAX} * kPart);  // unwatched heat is as large as it can be
  return static_cast<std::uint32_t>(std::clamp<std::int64_t>((most + kPart - 1) >> (kSquareBits - kInputBits), 1, UINT32_MAX));
}

MotorHeat heat_from(std::uint32_t input) {
  MotorHeat heat;
  heat.squares.fill(std::int64_t{input} << (kSquareBits - kInputBits));
  heat.has_begun = input != 0;
  return heat;
}

CommandLimit command_limit(const Motors& motors, const HeatBudget& budget, const MotorHeat& heat) {
  CommandLimit limit{motors, false};
  const std::int64_t most = warmest(heat);
  if (most <= budget.knee) return limit;
  const std::int64_t over = std::min((most - budget.knee) >> kSquareBits, budget.quarter);
  const std::int64_t lower = (budget.fall * (over * budget.of_quarter)) >> kQuarterBits;  // below 2^60
  limit.motors.limit -= static_cast<std::int32_t>(lower);
  limit.lowered = lower > 0;
  return limit;
}

void warm(const MotorCommands& commands, const HeatBudget& budget, MotorHeat& heat) {
  for (std::size_t i = 0; i < 3; ++i) {
    std::int64_t& square = heat.squares[i];
    if (!heat.has_begun) square = budget.knee;
    const std::int64_t now = (std::int64_t{commands[i]} * commands[i]) << kSquareBits;
    square += ((now - square) * budget.forgotten) >> kPartBits;  // below 2^63
  }
  heat.has_begun = true;
}

}  // namespace isotouch::core
