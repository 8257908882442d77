#include "host/evaluate/calibrate.h"

#include <algorithm>
#include <cmath>

#include "host/motion/device_in_hand.h"

namespace isotouch::evaluate {

std::optional<AngleCalibration> calibrate(const DeviceModel& model, const std::vector<Posture>& postures) {
  std::array<double, 3> sum{}, least{}, most{};
  for (std::size_t n = 0; n < postures.size(); ++n) {
    const auto expected = motion::counts_at(postures[n].grip_mm, model);
    if (!expected) return std::nullopt;
    for (std::size_t i = 0; i < sum.size(); ++i) {
      const double off = (*expected)[i] - postures[n].counts[i];  // counts that are missing at count 0
      sum[i] += off;
      least[i] = n == 0 ? off : std::min(least[i], off);
      most[i] = n == 0 ? off : std::max(most[i], off);
    }
  }
  AngleCalibration found{};
  for (std::size_t i = 0; i < sum.size(); ++i) {
    const DeviceLeg& leg = model.legs[i];
    const double units_a_count = std::ldexp(leg.per_count.raw(), -AnglePerCount::kFractionBits);
    const double turned = sum[i] / static_cast<double>(postures.size()) * units_a_count;
    const auto degrees = [](double units) { return std::ldexp(units, -32) * 360; };
    found.at_zero[i] = leg.at_zero + Angle::from_raw(static_cast<std::uint32_t>(std::llround(turned)));
    found.turned_deg[i] = degrees(turned);
    found.apart_deg = std::max(found.apart_deg, degrees((most[i] - least[i]) * units_a_count));
  }
  return found;
}

}  // namespace isotouch::evaluate
