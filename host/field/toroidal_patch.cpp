#include "host/field/toroidal_patch.h"

#include <algorithm>
#include <cmath>

namespace isotouch::field {

namespace {

/// The derivatives of `circle_distance` by u and w.
Eigen::Vector2d circle_gradient(double u, double w, double k) {
  const Eigen::Vector2d g(k * u, std::max(0.0, 1.0 + k * w));
  const double length = g.norm();
  return length > 0.0 ? Eigen::Vector2d(g / length) : Eigen::Vector2d(0.0, 0.0);
}

}  // namespace

ToroidalPatch::Value ToroidalPatch::value(const Eigen::Vector3d& x) const {
  const Eigen::Vector3d d = x - point;
  const double u = d.dot(across), v = d.dot(along), w = d.dot(normal);
  const double height = circle_distance(u, w, gentle);
  const Eigen::Vector2d inner = circle_gradient(u, w, gentle);
  const Eigen::Vector2d outer = circle_gradient(v, height, tight);
  return {circle_distance(v, height, tight), outer.x() * along + outer.y() * (inner.x() * across + inner.y() * normal)};
}

}  // namespace isotouch::field
