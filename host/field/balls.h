/// Packing radii: at every sample the largest ball that touches it from inside and holds no other sample.
///
/// For sample i and another sample j let a = P_j - P_i. Where -n_i·a > 0, one ball touches P_i with outward normal n_i and passes through
/// P_j; its radius is r_ij = |a|² / (2 (-n_i·a)), and the packing radius is the least of them. A sample with all others on or above its
/// tangent plane has no such ball: its radius is infinite, the ball is a half-space. The centre of a finite one is P_i - r_i n_i.
///
/// source    Sreeni K. G., Distance Field based Haptic Rendering of Scattered Oriented Points, 3.1, equations 2 and 3
#pragma once

#include <vector>

#include "host/cloud/oriented_points.h"

namespace isotouch::field {

/// The radii as published: every pair, N² of them.
///
/// points    any length unit; unit outward normals
/// returns   one radius a point, in the points' unit; infinite where no pair gives a ball
std::vector<double> packing_radii_brute_force(const cloud::OrientedPoints& points);

/// The same radii to the last bit, by shrinking balls: start from a large ball, ask for the sample nearest to its centre, shrink to it,
/// repeat. A few queries a sample; only a sample on whose ball many others lie (a perfect sphere) costs as much as by brute force.
///
/// source    Ma, Bae, Choi, 3D medial axis point approximation using nearest neighbors and the normal field, 2012
std::vector<double> packing_radii(const cloud::OrientedPoints& points);

}  // namespace isotouch::field
