/// A piece of surface as an osculating torus: a point, its normal and two principal curvatures, with the distance in closed form.
///
/// Plane, sphere, cylinder and torus are exact; any other smooth surface is met to second order. The distance is that of two circles, one
/// inside the other: first in the plane of the smaller curvature, then, with that distance as height, in the plane of the larger one.
///
/// source    toroidal patches as local approximants: Liu, Pottmann, Wang, Constrained 3D shape reconstruction using a combination of
/// surface
///           fitting and registration, 2006
#pragma once

#include <Eigen/Core>
#include <cmath>

namespace isotouch::field {

/// Signed distance of (u, w) from the circle of curvature k through the origin with tangent u, written so that k = 0 is no exception.
inline double circle_distance(double u, double w, double k) {
  const double towards_centre = 1.0 + k * w;
  const double ku = k * u;
  if (towards_centre < 0.0) return (std::abs(ku) - 1.0) / k;
  return (k * (u * u + w * w) + 2.0 * w) / (1.0 + std::sqrt(ku * ku + towards_centre * towards_centre));
}

struct ToroidalPatch {
  Eigen::Vector3d point, normal;     ///< on the surface; unit, outward
  Eigen::Vector3d across, along;     ///< unit directions of the smaller and of the larger |curvature|
  double gentle = 0.0, tight = 0.0;  ///< the two curvatures, 1 / length, positive where the body is convex

  /// Signed distance in the points' unit, negative inside. Its slope is at most one everywhere. Beyond a centre of curvature the circle
  /// goes on as a stadium, so that the far side of the torus never shows.
  double distance(const Eigen::Vector3d& x) const {
    const Eigen::Vector3d d = x - point;
    return circle_distance(d.dot(along), circle_distance(d.dot(across), d.dot(normal), gentle), tight);
  }

  struct Value {
    double distance;
    Eigen::Vector3d gradient;
  };
  Value value(const Eigen::Vector3d& x) const;
};

}  // namespace isotouch::field
