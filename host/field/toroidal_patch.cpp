#include "host/field/toroidal_patch.h"

#include <algorithm>
#include <cmath>

namespace isotouch::field {

namespace {

/// Signed distance of (u, w) from the circle of curvature k through the origin with tangent u, written so that k = 0 is no exception.
double circle_distance(double u, double w, double k) {
  const double towards_centre = 1.0 + k * w;
  const double ku = k * u;
  if (towards_centre < 0.0) return (std::abs(ku) - 1.0) / k;
  return (k * (u * u + w * w) + 2.0 * w) / (1.0 + std::sqrt(ku * ku + towards_centre * towards_centre));
}

/// Its derivatives by u and w.
Eigen::Vector2d circle_gradient(double u, double w, double k) {
  const Eigen::Vector2d g(k * u, std::max(0.0, 1.0 + k * w));
  const double length = g.norm();
  return length > 0.0 ? Eigen::Vector2d(g / length) : Eigen::Vector2d(0.0, 0.0);
}

}  // namespace

double ToroidalPatch::distance(const Eigen::Vector3d& x) const {
  const Eigen::Vector3d d = x - point;
  return circle_distance(d.dot(along), circle_distance(d.dot(across), d.dot(normal), gentle), tight);
}

ToroidalPatch::Value ToroidalPatch::value(const Eigen::Vector3d& x) const {
  const Eigen::Vector3d d = x - point;
  const double u = d.dot(across), v = d.dot(along), w = d.dot(normal);
  const double height = circle_distance(u, w, gentle);
  const Eigen::Vector2d inner = circle_gradient(u, w, gentle);
  const Eigen::Vector2d outer = circle_gradient(v, height, tight);
  return {circle_distance(v, height, tight), outer.x() * along + outer.y() * (inner.x() * across + inner.y() * normal)};
}

}  // namespace isotouch::field
