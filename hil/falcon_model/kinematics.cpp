#include "hil/falcon_model/kinematics.h"

#include <cmath>

namespace isotouch::falcon_model {

namespace {

constexpr Vector kAxisZ{0, 0, 1};

/// Solves rows · x = right by Cramer's rule.
std::optional<Vector> solve(const Vector& a, const Vector& b, const Vector& c, const Vector& right) {
  const Vector bc = cross(b, c), ca = cross(c, a), ab = cross(a, b);
  const double determinant = dot(a, bc);
  const double size = length(a) * length(b) * length(c);
  if (!(determinant > 1e-9 * size || determinant < -1e-9 * size)) return std::nullopt;
  return 1 / determinant * (right.x * bc + right.y * ca + right.z * ab);
}

}  // namespace

Kinematics::Kinematics(const Geometry& geometry) : geometry_(geometry), axes_{} {
  for (std::size_t i = 0; i < kLegs; ++i) {
    const double c = cosine(geometry.azimuth[i]), s = sine(geometry.azimuth[i]);
    axes_[i] = {{c, s, 0}, {-s, c, 0}};
  }
}

std::optional<Legs> Kinematics::legs(const Vector& grip) const {
  const Geometry& g = geometry_;
  Legs legs;
  for (std::size_t i = 0; i < kLegs; ++i) {
    const Vector &radial = axes_[i].radial, &tangential = axes_[i].tangential;
    const double q = dot(grip, tangential) + g.offset_tangential;
    const double square = g.parallelogram * g.parallelogram - q * q;
    if (!(square > 0)) return std::nullopt;
    const double out = std::sqrt(square);  // b sin(theta 3)
    const double reach = g.offset_along + out;
    const double along = dot(grip, radial) + g.offset_radial;
    const double distance = std::sqrt(along * along + grip.z * grip.z);
    if (!(distance > 0)) return std::nullopt;
    // The triangle of upper arm, reach and distance: the angle at the shoulder.
    const double cosine_inner = (distance * distance + g.upper_arm * g.upper_arm - reach * reach) / (2 * g.upper_arm * distance);
    if (!(cosine_inner > -1 && cosine_inner < 1)) return std::nullopt;
    const double sine_inner = std::sqrt(1 - cosine_inner * cosine_inner);
    const double cos1 = (along * cosine_inner + grip.z * sine_inner) / distance;
    const double sin1 = (grip.z * cosine_inner - along * sine_inner) / distance;
    const double cos2 = (along - g.upper_arm * cos1) / reach;
    const double sin2 = (grip.z - g.upper_arm * sin1) / reach;
    const double lever = g.upper_arm * (sin2 * cos1 - cos2 * sin1) * out / g.parallelogram;  // a sin(theta 3) sin(theta 2 - theta 1)
    const double sin3 = out / g.parallelogram, cos3 = q / g.parallelogram;
    legs[i] = {cos1, sin1, 1 / lever * (cos2 * sin3 * radial + cos3 * tangential + sin2 * sin3 * kAxisZ)};
  }
  return legs;
}

std::optional<Vector> Kinematics::grip(const Angles& angles, const Vector& near) const {
  const Geometry& g = geometry_;
  Vector p = near;
  for (int step = 0; step < 40; ++step) {
    std::array<Vector, kLegs> gradient;
    std::array<double, kLegs> residual{};
    for (std::size_t i = 0; i < kLegs; ++i) {
      const Vector &radial = axes_[i].radial, &tangential = axes_[i].tangential;
      const double q = dot(p, tangential) + g.offset_tangential;
      const double square = g.parallelogram * g.parallelogram - q * q;
      if (!(square > 0)) return std::nullopt;
      const double out = std::sqrt(square);
      const double reach = g.offset_along + out;
      const double along = dot(p, radial) + g.offset_radial - g.upper_arm * cosine(angles[i]);
      const double above = p.z - g.upper_arm * sine(angles[i]);
      residual[i] = along * along + above * above - reach * reach;
      gradient[i] = 2 * along * radial + 2 * reach * q / out * tangential + 2 * above * kAxisZ;
    }
    const auto move = solve(gradient[0], gradient[1], gradient[2], {residual[0], residual[1], residual[2]});
    if (!move) return std::nullopt;
    const double far = length(*move);
    p = p - (far > 20 ? 20 / far : 1.0) * *move;  // a longer step may leave the space that the parallelograms reach
    if (far < 1e-9) return p;
  }
  return std::nullopt;
}

Vector force_of(const Legs& legs, const Torques& torques) {
  return torques[0] * legs[0].angle_per_mm + torques[1] * legs[1].angle_per_mm + torques[2] * legs[2].angle_per_mm;
}

std::optional<Torques> torques_of(const Legs& legs, const Vector& force) {
  const Vector &a = legs[0].angle_per_mm, &b = legs[1].angle_per_mm, &c = legs[2].angle_per_mm;
  const auto t = solve({a.x, b.x, c.x}, {a.y, b.y, c.y}, {a.z, b.z, c.z}, force);
  if (!t) return std::nullopt;
  return Torques{t->x, t->y, t->z};
}

}  // namespace isotouch::falcon_model
