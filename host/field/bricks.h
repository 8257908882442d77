/// The bricks of a band, found by walking along the surface: cost grows with its area, never with the volume.
#pragma once

#include <Eigen/Core>
#include <array>
#include <functional>
#include <optional>
#include <vector>

#include "host/field/band_field.h"

namespace isotouch::field {

/// Signed distances of one brick, voxels.
struct BrickDistances {
  double middle = 0.0;                           ///< at its middle, where there are no samples
  std::optional<std::array<float, 64>> samples;  ///< at its samples, x fastest; nothing when the middle is too far from the surface
  bool jumps = false;                            ///< towards its neighbours the distance may jump
};

/// A signed distance on a grid, voxels. Called from several threads at once.
struct SampledDistance {
  std::function<double(const Eigen::Vector3d& index)> at;  ///< at a point in index coordinates
  /// Of a brick; it may leave the samples out where the distance at its middle is beyond ±reach.
  std::function<BrickDistances(const Eigen::Vector3i& cell, double reach)> brick;
  double slope = 1.5;  ///< the distance changes by no more than this a voxel; a true distance by one, blended models by a little more
};

/// Every brick with a sample within the band that neighbours, face to face, lead to from a seed, and what it takes to make the answer closed:
/// a brick that is not listed has one sign, the same as every neighbour has on the face towards it, and along each row of bricks that are not
/// listed the sign does not change. Where the distance jumps over the band between two bricks, both are listed; where a sheet of the surface
/// was not reached by a seed but shows by its sign, the walk goes on from there.
///
/// distance   positive on the border of the grid
/// cells      bricks along each axis, below 2^21
/// band       half width, voxels
/// seeds      brick coordinates in any order, repeats allowed; outside [0, cells) they are ignored
/// returns    sorted by z, then y, then x
std::vector<Brick> band_bricks(const SampledDistance& distance, const Eigen::Vector3i& cells, double band,
                               const std::vector<Eigen::Vector3i>& seeds);

}  // namespace isotouch::field
