/// Two balls at every sample that hold no other sample, one inside the surface and one outside: what is known about places between samples.
///
/// A local model is only known to be right near the samples that it explains; further away one of its planes may cut through free space or
/// leave a hollow in the body. The balls say where the scan has seen nothing in between.
///
/// source    packing radii: Sreeni K. G., Distance Field based Haptic Rendering of Scattered Oriented Points, 3.1, equations 2 and 3, on both sides
#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "host/field/scan.h"

namespace isotouch::field {

struct EmptyBalls {
  Eigen::Vector3d inner, outer;                   ///< centres, on the sample's normal line
  double inner_radius = 0.0, outer_radius = 0.0;  ///< capped at kBallCap spacings
  double slack = 0.0;                             ///< how far a ball may reach through the surface between samples
};

/// Balls are not grown beyond this many spacings.
inline constexpr double kBallCap = 6.0;

std::vector<EmptyBalls> empty_balls(const Scan& scan);

/// A signed distance, held to what the balls of the samples nearest to x agree on: three of them must call a place outside, or inside, before it
/// is. One sample with a wrong normal decides nothing.
///
/// distance  of x by the local models
/// nearest   samples, nearest first; with fewer than three nothing is held
double held_by_balls(double distance, const Eigen::Vector3d& x, std::span<const Neighbour> nearest, const std::vector<EmptyBalls>& balls);

}  // namespace isotouch::field
