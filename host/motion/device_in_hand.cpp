#include "host/motion/device_in_hand.h"

#include <cmath>
#include <cstddef>
#include <numbers>

#include "host/field/angle.h"
#include "host/motion/hand.h"
#include "host/to_double.h"

namespace isotouch::motion {

namespace {

constexpr double kUnitsPerRadian = 4294967296.0 / (2 * std::numbers::pi);

}  // namespace

std::optional<std::array<double, 3>> counts_at(const Eigen::Vector3d& grip, const DeviceModel& model) {
  const double a = to_double(model.arm);
  const double b = to_double(model.rod);
  std::array<double, 3> counts{};
  for (std::size_t i = 0; i < counts.size(); ++i) {
    const DeviceLeg& leg = model.legs[i];
    const double phi = leg.azimuth.raw() / kUnitsPerRadian;
    const double q = -grip.x() * std::sin(phi) + grip.y() * std::cos(phi) + to_double(model.tangential);
    const double along = grip.x() * std::cos(phi) + grip.y() * std::sin(phi) + to_double(model.radial);
    if (!(std::abs(q) < b)) return std::nullopt;
    const double reach = to_double(model.joint) + std::sqrt(b * b - q * q);
    const double rho = std::sqrt(along * along + grip.z() * grip.z());
    const double cosine = (rho * rho + a * a - reach * reach) / (2 * a * rho);
    if (!(std::abs(cosine) <= 1)) return std::nullopt;
    const double theta = field::angle_of(grip.z(), along) - field::angle_of(std::sqrt(1 - cosine * cosine), cosine);
    const double turned = std::remainder(theta * kUnitsPerRadian - leg.at_zero.raw(), 4294967296.0);
    counts[i] = turned * (1 << AnglePerCount::kFractionBits) / leg.per_count.raw();
  }
  return counts;
}

Input DeviceInHand::operator()(const Input& hand) {
  const auto counts = counts_at(to_double(hand.hip + model_.workspace_origin), model_);
  bool reached = counts.has_value();
  for (std::size_t i = 0; reached && i < 3; ++i) reached = std::abs((*counts)[i]) < 32767;
  if (reached) {
    for (std::size_t i = 0; i < 3; ++i) reply_.counts[i] = static_cast<std::int16_t>(std::lround((*counts)[i]));
  } else {
    ++out_of_reach_;
  }
  reply_.buttons = hand.buttons;
  reply_.homed = 7;
  Input in;
  in.packet = encode(reply_);
  in.fresh = hand.fresh;
  in.age = hand.age;
  keep_field(hand, in);
  return in;
}

}  // namespace isotouch::motion
