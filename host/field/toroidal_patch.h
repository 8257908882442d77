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

namespace isotouch::field {

struct ToroidalPatch {
  Eigen::Vector3d point, normal;     ///< on the surface; unit, outward
  Eigen::Vector3d across, along;     ///< unit directions of the smaller and of the larger |curvature|
  double gentle = 0.0, tight = 0.0;  ///< the two curvatures, 1 / length, positive where the body is convex

  /// Signed distance in the points' unit, negative inside. Its slope is at most one everywhere. Beyond a centre of curvature the circle
  /// goes on as a stadium, so that the far side of the torus never shows.
  double distance(const Eigen::Vector3d& x) const;

  struct Value {
    double distance;
    Eigen::Vector3d gradient;
  };
  Value value(const Eigen::Vector3d& x) const;
};

}  // namespace isotouch::field
