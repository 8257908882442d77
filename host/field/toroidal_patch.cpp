#include "host/field/toroidal_patch.h"

#include <cmath>

namespace isotouch::field {

namespace {

/// `circle_distance` and its derivatives by u and w.
struct Circle {
  double distance, by_u, by_w;
};

Circle circle(double u, double w, double k) {
  const double towards_centre = 1.0 + k * w, ku = k * u;
  const bool beyond = towards_centre < 0.0;
  const double forward = beyond ? 0.0 : towards_centre;
  const double length = std::sqrt(ku * ku + forward * forward);
  const double distance = beyond ? (std::abs(ku) - 1.0) / k : (k * (u * u + w * w) + 2.0 * w) / (1.0 + length);
  return length > 0.0 ? Circle{distance, ku / length, forward / length} : Circle{distance, 0.0, 0.0};
}

}  // namespace

ToroidalPatch::Value ToroidalPatch::value(const Eigen::Vector3d& x) const {
  const Eigen::Vector3d d = x - point;
  const double u = d.dot(across), v = d.dot(along), w = d.dot(normal);
  const Circle inner = circle(u, w, gentle), outer = circle(v, inner.distance, tight);
  return {outer.distance, outer.by_u * along + outer.by_w * (inner.by_u * across + inner.by_w * normal)};
}

}  // namespace isotouch::field
