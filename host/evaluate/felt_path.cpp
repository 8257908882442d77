#include "host/evaluate/felt_path.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "host/to_double.h"

namespace isotouch::evaluate {

using Eigen::Vector3d;

namespace {

constexpr double kTurning = 0.2;   // share of the way to the new normal in one tick: corners of the mesh do not jerk the hand
constexpr double kLifting = 0.5;   // share of the depth's error that a tick corrects
constexpr double kMaxLift = 0.15;  // mm a tick
constexpr int kSinking = 80;       // ticks at most: 4 mm at kMaxLift and what is left then by halves

}  // namespace

FeltPath::FeltPath(const field::TriangleTree& tree, const Vector3d& start) : object_(tree, start), hip_(start) { step(start); }

void FeltPath::step(const Vector3d& hip) {
  hip_ = hip;
  const Vec3<Mm> rounded = to_fixed<Mm>(hip);
  object_.settle(to_double(rounded));
  ticks_.push_back({rounded, object_.position(), object_.touching()});
}

void FeltPath::move(const Vector3d& to, double mm_per_tick) {
  const Vector3d from = hip_;
  const double steps = std::ceil((to - from).norm() / mm_per_tick);
  for (double i = 1; i <= steps; ++i) step(i < steps ? Vector3d(from + i * mm_per_tick * (to - from).normalized()) : to);
}

void FeltPath::hold(int ticks) {
  for (int i = 0; i < ticks; ++i) step(hip_);
}

SteeredHand::SteeredHand(const field::TriangleTree& tree, FeltPath& path, const Vector3d& outward, const Vector3d& heading)
    : tree_(tree), path_(path), outward_(outward), heading_((heading - heading.dot(outward) * outward).normalized()) {}

Vector3d SteeredHand::aside() const { return outward_.cross(heading_); }

void SteeredHand::step(double ahead, double aside_mm, double depth) {
  const Vector3d& hip = path_.hip();
  double height = 0;
  Vector3d out = outward_;
  if (path_.touching()) {
    const Vector3d deflection = path_.god() - hip;
    height = -deflection.norm();
    if (height < -1e-6) out = deflection / -height;
  } else {
    const Vector3d away = hip - tree_.nearest(hip).point;
    height = away.norm();
    if (height > 1e-6) out = away / height;
  }
  const Vector3d turned = outward_ + kTurning * (out - outward_);
  if (turned.norm() > 0.1) outward_ = turned.normalized();
  const Vector3d along = heading_ - heading_.dot(outward_) * outward_;
  heading_ = along.norm() > 1e-3 ? Vector3d(along.normalized()) : outward_.unitOrthogonal();
  const double lift = std::clamp(kLifting * (-depth - height), -kMaxLift, kMaxLift);
  path_.step(hip + ahead * heading_ + aside_mm * aside() + lift * outward_);
}

void SteeredHand::turn(double tangent) { heading_ = (heading_ + tangent * aside()).normalized(); }

void SteeredHand::sink(double depth) {
  for (int tick = 0; tick < kSinking; ++tick) {
    if (path_.touching() && std::fabs((path_.god() - path_.hip()).norm() - depth) < 0.02 * depth) return;
    step(0, 0, depth);
  }
}

}  // namespace isotouch::evaluate
