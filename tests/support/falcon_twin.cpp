#include "tests/support/falcon_twin.h"

#include <cmath>
#include <cstddef>

namespace isotouch::test {

namespace {

constexpr double kDegree = 0.017453292519943295;
constexpr std::array<double, 3> kAzimuths = {105 * kDegree, -15 * kDegree, -135 * kDegree};

/// One leg at one place of the grip.
struct Leg {
  Point u, v;      // along and across its azimuth
  double q, e, A;  // cosθ3 · b, E, U + c
};

Leg leg_at(const FalconTwin& m, std::size_t i, const Point& p) {
  Leg leg;
  leg.u = {std::cos(kAzimuths[i]), std::sin(kAzimuths[i]), 0};
  leg.v = {-leg.u.y, leg.u.x, 0};
  leg.q = dot(p, leg.v) + m.kappa_sign * (m.f - m.s);
  leg.e = m.d_plus_e + std::sqrt(m.b * m.b - leg.q * leg.q);
  leg.A = dot(p, leg.u) - m.r + m.c;
  return leg;
}

}  // namespace

std::optional<Angles> FalconTwin::inverse(const Point& grip) const {
  Angles angles;
  for (std::size_t i = 0; i < 3; ++i) {
    const Leg leg = leg_at(*this, i, grip);
    const double rho = std::hypot(leg.A, grip.z);
    const double cosine = (rho * rho + a * a - leg.e * leg.e) / (2 * a * rho);
    if (!(std::abs(leg.q) <= b) || !(std::abs(cosine) <= 1)) return std::nullopt;
    angles[i] = std::atan2(grip.z, leg.A) - std::acos(cosine);
  }
  return angles;
}

std::optional<Point> FalconTwin::forward(const Angles& angles, const Point& start) const {
  Point p = start;
  for (int step = 0; step < 60; ++step) {
    std::array<Point, 3> rows;
    Point residual;
    for (std::size_t i = 0; i < 3; ++i) {
      const Leg leg = leg_at(*this, i, p);
      const double x = leg.A - a * std::cos(angles[i]);
      const double z = p.z - a * std::sin(angles[i]);
      rows[i] = (leg.u * x + leg.v * (leg.e * leg.q / std::sqrt(b * b - leg.q * leg.q)) + Point{0, 0, z}) * 2;
      residual[i] = x * x + z * z - leg.e * leg.e;
    }
    const Point change = solve(rows, residual);
    if (!(length(change) < 1e6)) return std::nullopt;
    p = p - change * std::min(1.0, 20 / (length(change) + 1e-12));
    if (length(change) < 1e-11) return p;
  }
  return std::nullopt;
}

std::array<Point, 3> FalconTwin::jacobian(const Point& grip, const Angles& angles) const {
  std::array<Point, 3> rows;
  for (std::size_t i = 0; i < 3; ++i) {
    const Leg leg = leg_at(*this, i, grip);
    const double theta3 = std::acos(leg.q / b);
    const double theta2 = std::atan2(grip.z - a * std::sin(angles[i]), leg.A - a * std::cos(angles[i]));
    const Point numerator =
        leg.u * (std::cos(theta2) * std::sin(theta3)) + leg.v * std::cos(theta3) + Point{0, 0, std::sin(theta2) * std::sin(theta3)};
    rows[i] = numerator * (1 / (a * std::sin(theta3) * std::sin(theta2 - angles[i])));
  }
  return rows;
}

Angles FalconTwin::torques(const Point& grip, const Angles& angles, const Point& force) const {
  const std::array<Point, 3> j = jacobian(grip, angles);
  const Point tau = solve({Point{j[0].x, j[1].x, j[2].x}, Point{j[0].y, j[1].y, j[2].y}, Point{j[0].z, j[1].z, j[2].z}}, force);
  return {tau.x, tau.y, tau.z};
}

Angles FalconTwin::angles_of(const std::array<std::int16_t, 3>& counts) const {
  Angles angles;
  for (std::size_t i = 0; i < 3; ++i) angles[i] = radians_at_zero + radians_per_count * counts[i];
  return angles;
}

Angles FalconTwin::counts_of(const Angles& angles) const {
  Angles counts;
  for (std::size_t i = 0; i < 3; ++i) counts[i] = (angles[i] - radians_at_zero) / radians_per_count;
  return counts;
}

FalconTwin libnifalcon_twin() { return {60, 102.5, 14.43, 22.5, -25, 40, -23.09, 1, 0.0364346591 * kDegree, 35 * kDegree, 0.1}; }

FalconTwin martin_hillier_twin() {
  return {60, 102.5, 15.7, 23, 26.2, 36.6, 27.2, -1, 360.0 / (1280 * 7.62) * kDegree, 40 * kDegree, 0.15114};
}

std::array<FalconSet, 2> falcon_sets() {
  return {FalconSet{"libnifalcon", libnifalcon_twin(), libnifalcon_model()},
          FalconSet{"Martin and Hillier", martin_hillier_twin(), martin_hillier_model()}};
}

Point solve(const std::array<Point, 3>& rows, const Point& right) {
  const Point c0 = cross(rows[1], rows[2]);
  const Point c1 = cross(rows[2], rows[0]);
  const Point c2 = cross(rows[0], rows[1]);
  return (c0 * right.x + c1 * right.y + c2 * right.z) * (1 / dot(rows[0], c0));
}

std::optional<std::array<std::int16_t, 3>> nearest_counts(const FalconTwin& twin, const Point& grip, double limit) {
  const std::optional<Angles> angles = twin.inverse(grip);
  if (!angles) return std::nullopt;
  std::array<std::int16_t, 3> counts;
  for (std::size_t i = 0; i < 3; ++i) {
    const double count = twin.counts_of(*angles)[i];
    if (!(std::abs(count) <= limit)) return std::nullopt;
    counts[i] = static_cast<std::int16_t>(std::lround(count));
  }
  return counts;
}

}  // namespace isotouch::test
