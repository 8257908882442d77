/// From samples of one smooth piece to its osculating torus.
#pragma once

#include <Eigen/Core>
#include <span>

#include "host/field/toroidal_patch.h"

namespace isotouch::field {

/// A sample as seen by a fit.
struct WeightedSample {
  Eigen::Vector3d position, normal;
  double weight;
};

/// The patch at the first sample that explains all of them best. First the curvatures, from how the normals turn: least squares of
/// n_j - n = H (P_j - P) in the tangent plane, exact on spheres and cylinders. Then one Gauss-Newton step of offset, tilt and curvatures on the
/// distances and gradients that this torus really has at the samples; it takes the noise of single normals back, and does nothing where the
/// torus is already right.
///
/// samples   at least one; weight 1 for the first, 0 to 1 falling with distance for the others
/// reach     radius of the neighbourhood they were taken from, their length unit, above zero
/// returns   directions in which no sample lies stay straight; a single sample gives its tangent plane
ToroidalPatch fit_patch(std::span<const WeightedSample> samples, double reach);

/// Of samples with noise.
struct Variances {
  double position;  ///< across the surface, their length unit squared
  double normal;    ///< radians squared
};

/// One Gauss-Newton step from a patch towards the one that explains all samples best. None counts more than the others.
///
/// samples   at least 3; their weights are not read
/// reach     radius of the neighbourhood they were taken from, above zero
ToroidalPatch nearer_patch(const ToroidalPatch& patch, std::span<const WeightedSample> samples, const Variances& variances, double reach);

}  // namespace isotouch::field
