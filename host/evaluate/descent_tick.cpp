#include "host/evaluate/descent_tick.h"

#include <algorithm>
#include <cmath>

namespace isotouch::evaluate {

template <class Real>
LevelSample<Real> sample_levels(const published::LevelField& levels, const Eigen::Vector3<Real>& point) {
  using Vector = Eigen::Vector3<Real>;
  const Eigen::Vector3i& size = levels.grid.size;
  const Eigen::Array3<Real> floor(std::floor(point.x()), std::floor(point.y()), std::floor(point.z()));
  // Written so that a NaN is outside too.
  if (!((floor >= 1).all() && (floor + 2 < size.cast<Real>().array()).all())) return {published::kOutsideLevel, Vector::Zero()};
  const Vector t = point.array() - floor;
  const std::int8_t* corner =
      &levels.values[levels.place(static_cast<int>(floor.x()), static_cast<int>(floor.y()), static_cast<int>(floor.z()))];
  const auto sy = static_cast<std::ptrdiff_t>(levels.stride(1));
  const auto sz = static_cast<std::ptrdiff_t>(levels.stride(2));

  LevelSample<Real> sample{0, Vector::Zero()};
  for (int n = 0; n < 8; ++n) {
    const int x = n & 1;
    const int y = (n >> 1) & 1;
    const int z = n >> 2;
    const std::int8_t* node = corner + x + y * sy + z * sz;
    const Real weight = (x != 0 ? t.x() : 1 - t.x()) * (y != 0 ? t.y() : 1 - t.y()) * (z != 0 ? t.z() : 1 - t.z());
    sample.level += weight * static_cast<Real>(*node);
    const Vector difference(static_cast<Real>(node[1] - node[-1]), static_cast<Real>(node[sy] - node[-sy]),
                            static_cast<Real>(node[sz] - node[-sz]));
    sample.gradient += weight / 2 * difference;
  }
  return sample;
}

template <class Real>
DescentTick<Real>::DescentTick(const published::LevelField& levels, Real stiffness)
    : levels_(levels), origin_(levels.grid.origin.cast<Real>()), edge_(static_cast<Real>(levels.grid.edge)), stiffness_(stiffness) {}

template <class Real>
typename DescentTick<Real>::Vector DescentTick<Real>::force(const Vector& hip) {
  const Vector hand = (hip - origin_) / edge_;
  if (!inside_) proxy_ = hand;
  for (int step = 0; step < core::kDescentSteps; ++step) {
    const LevelSample<Real> at = sample_levels<Real>(levels_, proxy_);
    proxy_ -= kGamma * ((proxy_ - hand) + kLambda * std::min<Real>(at.level, 0) * at.gradient);
  }
  inside_ = sample_levels<Real>(levels_, proxy_).level < 0;
  if (inside_) return stiffness_ * edge_ * (proxy_ - hand);
  proxy_ = hand;
  return Vector::Zero();
}

template class DescentTick<float>;
template class DescentTick<double>;
template LevelSample<float> sample_levels(const published::LevelField& levels, const Eigen::Vector3f& point);
template LevelSample<double> sample_levels(const published::LevelField& levels, const Eigen::Vector3d& point);

}  // namespace isotouch::evaluate
