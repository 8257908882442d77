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

}  // namespace isotouch::field
