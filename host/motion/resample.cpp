#include "host/motion/resample.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "host/error.h"
#include "host/motion/motion.h"
#include "host/to_double.h"

namespace isotouch::motion {

using Eigen::Vector3d;

namespace {

constexpr double kSlack = 5e-7;        // of a tick, or of the longest gap: what rounding may do to decimal times since the first sample
constexpr double kLeastApart = 1e-12;  // s; between samples that are nearer, a velocity may have no number

/// The velocity at the sample between two intervals of lengths `before`, `after` and mean velocities `u`, `v`, along one axis.
double velocity_between(double before, double u, double after, double v) {
  if (u * v <= 0) return 0;
  return 3 * (before + after) / ((2 * after + before) / u + (after + 2 * before) / v);
}

std::vector<Vector3d> velocities(const std::vector<TimedPoint>& points) {
  std::vector<Vector3d> result(points.size(), Vector3d::Zero());
  const auto mean = [&](std::size_t i) -> Vector3d {
    return (points[i + 1].position - points[i].position) / (points[i + 1].time - points[i].time);
  };
  for (std::size_t i = 1; i + 1 < points.size(); ++i) {
    const Vector3d u = mean(i - 1);
    const Vector3d v = mean(i);
    const double before = points[i].time - points[i - 1].time;
    const double after = points[i + 1].time - points[i].time;
    for (int axis = 0; axis < 3; ++axis) result[i][axis] = velocity_between(before, u[axis], after, v[axis]);
  }
  result.front() = mean(0);
  result.back() = mean(points.size() - 2);
  return result;
}

}  // namespace

std::uint64_t resample(const std::vector<TimedPoint>& points, std::uint32_t period_ns,
                       const std::function<void(const Input&, const std::optional<Vector3d>& force)>& emit) {
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double farthest = points[i].position.cwiseAbs().maxCoeff();
    if (!points[i].position.allFinite() || farthest > kMaxMm) {
      throw InputError("sample " + std::to_string(i + 1) + " lies " + std::to_string(farthest) +
                       " mm from the workspace's centre, a trace holds ±2047 mm; use --centre, --scale, --offset or the right unit");
    }
  }
  for (std::size_t i = 1; i < points.size(); ++i) {
    if (!(points[i].time - points[i - 1].time >= kLeastApart))
      throw InputError("sample " + std::to_string(i + 1) + " comes less than a picosecond after the one before; leave one of them out");
  }
  const double period = period_ns * 1e-9;
  const double whole = (points.back().time - points.front().time) / period;
  if (whole >= static_cast<double>(kMaxTicks)) throw InputError("the motion lasts more than 100,000,000 ticks; check the unit of its time");

  const auto ticks = static_cast<std::uint64_t>(std::floor(whole + kSlack)) + 1;
  const std::vector<Vector3d> velocity = velocities(points);
  std::size_t i = 0;
  for (std::uint64_t tick = 0; tick < ticks; ++tick) {
    const double time = points.front().time + static_cast<double>(tick) * period;
    while (i + 2 < points.size() && time >= points[i + 1].time) ++i;
    const double length = points[i + 1].time - points[i].time;
    const double s = std::min(1.0, (time - points[i].time) / length);
    const double r = 1 - s;
    const Vector3d position = r * r * (1 + 2 * s) * points[i].position + s * s * (1 + 2 * r) * points[i + 1].position +
                              s * r * length * (r * velocity[i] - s * velocity[i + 1]);
    const bool is_sample = std::min(s, r) * length <= kSlack * period;
    std::optional<Vector3d> force;
    if (is_sample || length <= kMaxGap * (1 + kSlack)) force = r * points[i].force + s * points[i + 1].force;
    emit(position_input(to_fixed<Mm>(position)), force);
  }
  return ticks;
}

}  // namespace isotouch::motion
