#include "host/evaluate/descent_tick.h"

#include <algorithm>
#include <cmath>

namespace isotouch::evaluate {

LevelSample sample_levels(const published::LevelField& levels, const Eigen::Vector3f& point) {
  const Eigen::Vector3i& size = levels.grid.size;
  const Eigen::Array3f floor(std::floor(point.x()), std::floor(point.y()), std::floor(point.z()));
  // Written so that a NaN is outside too.
  if (!((floor >= 1).all() && (floor + 2 < size.cast<float>().array()).all())) return {published::kOutsideLevel, Eigen::Vector3f::Zero()};
  const Eigen::Vector3f t = point.array() - floor;
  const std::int8_t* corner =
      &levels.values[levels.place(static_cast<int>(floor.x()), static_cast<int>(floor.y()), static_cast<int>(floor.z()))];
  const auto sy = static_cast<std::ptrdiff_t>(levels.stride(1));
  const auto sz = static_cast<std::ptrdiff_t>(levels.stride(2));

  LevelSample sample{0, Eigen::Vector3f::Zero()};
  for (int n = 0; n < 8; ++n) {
    const int x = n & 1;
    const int y = (n >> 1) & 1;
    const int z = n >> 2;
    const std::int8_t* node = corner + x + y * sy + z * sz;
    const float weight = (x != 0 ? t.x() : 1 - t.x()) * (y != 0 ? t.y() : 1 - t.y()) * (z != 0 ? t.z() : 1 - t.z());
    sample.level += weight * static_cast<float>(*node);
    const Eigen::Vector3f difference(static_cast<float>(node[1] - node[-1]), static_cast<float>(node[sy] - node[-sy]),
                                     static_cast<float>(node[sz] - node[-sz]));
    sample.gradient += weight / 2 * difference;
  }
  return sample;
}

DescentTick::DescentTick(const published::LevelField& levels, float stiffness)
    : levels_(levels), origin_(levels.grid.origin.cast<float>()), edge_(static_cast<float>(levels.grid.edge)), stiffness_(stiffness) {}

Eigen::Vector3f DescentTick::force(const Eigen::Vector3f& hip) {
  const Eigen::Vector3f hand = (hip - origin_) / edge_;
  if (!inside_) proxy_ = hand;
  for (int step = 0; step < core::kDescentSteps; ++step) {
    const LevelSample at = sample_levels(levels_, proxy_);
    proxy_ -= kGamma * ((proxy_ - hand) + kLambda * std::min(at.level, 0.0F) * at.gradient);
  }
  inside_ = sample_levels(levels_, proxy_).level < 0;
  if (inside_) return stiffness_ * edge_ * (proxy_ - hand);
  proxy_ = hand;
  return Eigen::Vector3f::Zero();
}

}  // namespace isotouch::evaluate
