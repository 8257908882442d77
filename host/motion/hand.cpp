#include "host/motion/hand.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "host/to_double.h"

namespace isotouch::motion {

namespace {

constexpr double kPeakOverMean = 1.875;  // of a minimum-jerk movement

}  // namespace

double minimum_jerk(double share) {
  const double s = std::clamp(share, 0.0, 1.0);
  return s * s * s * (10.0 + s * (6.0 * s - 15.0));
}

double wave(double phase) {
  const double t = 4 * std::abs(phase - std::floor(phase) - 0.5) - 1;
  return t * (3 - t * t) / 2;
}

void keep_field(const Input& recorded, Input& tick) {
  tick.field_generation = recorded.field_generation;
  if ((recorded.requests & kRequestMoved) == 0) return;
  tick.requests |= kRequestMoved;
  tick.moved_to = recorded.moved_to;
  tick.author = recorded.author;
}

Hand::Hand(const Options& options, Emit emit) : options_(options), emit_(std::move(emit)), losses_(options.seed) {}

void Hand::step(const Eigen::Vector3d& to) {
  position_ = to;
  if (done()) return;
  if (lost_ticks_ == 0 && emitted_ > 0 && options_.loss_begins > 0 && losses_.uniform() < options_.loss_begins) {
    lost_ticks_ = 1 + static_cast<int>(losses_.bits() % 3);
  }
  if (lost_ticks_ > 0) {
    --lost_ticks_;
    last_.fresh = false;
    ++last_.age;
  } else {
    last_ = position_input(to_fixed<Mm>(to));
  }
  emit_(last_);
  ++emitted_;
}

void Hand::move(const Eigen::Vector3d& to, double peak) { move_along({to}, peak); }

void Hand::move_along(const std::vector<Eigen::Vector3d>& via, double peak) {
  const Eigen::Vector3d from = position_;
  double length = 0;
  Eigen::Vector3d before = from;
  for (const Eigen::Vector3d& point : via) {
    length += (point - before).norm();
    before = point;
  }
  const double ticks = std::max(1.0, std::ceil(kPeakOverMean * length / (peak * options_.period_s)));
  double passed = 0;  // length of the legs behind
  std::size_t leg = 0;
  Eigen::Vector3d begin = from;
  for (double tick = 1; tick <= ticks && !done(); ++tick) {
    const double travelled = length * minimum_jerk(tick / ticks);
    double leg_length = (via[leg] - begin).norm();
    while (leg + 1 < via.size() && travelled > passed + leg_length) {
      passed += leg_length;
      begin = via[leg++];
      leg_length = (via[leg] - begin).norm();
    }
    const double share = leg_length > 0 ? std::min(1.0, (travelled - passed) / leg_length) : 1.0;
    step(begin + share * (via[leg] - begin));
  }
  position_ = via.back();
}

void Hand::hold(double seconds) {
  const double ticks = std::floor(seconds / options_.period_s + 0.5);
  for (double tick = 0; tick < ticks && !done(); ++tick) step(Eigen::Vector3d(position_));
}

}  // namespace isotouch::motion
