/// The values of one brick of a live field, from the samples near it.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "host/encoding/brick_tree.h"
#include "host/encoding/spline.h"
#include "host/field/blend_brick.h"
#include "host/field/local_model.h"

namespace isotouch::live {

/// How far things reach, voxels.
struct Reach {
  double band;   ///< half width
  double depth;  ///< behind a sample there is body up to here: twice the band and one, so that a layer of it is far inside
  double blend;  ///< a sample farther away than that says nothing of a place: depth and band

  explicit constexpr Reach(double band_voxels) : band(band_voxels), depth(2.0 * band_voxels + 1.0), blend(depth + band_voxels) {}
};

/// What a sample says of places near it.
struct LiveModel {
  field::LocalModel model;
  field::BrickBlend::Model blended;  ///< the same for the blend; `body` is how far there is body to the sides
};

/// A sample near a brick.
struct Candidate {
  double squared_distance;  ///< from the brick's middle
  std::uint64_t key;        ///< of its bucket
  const Eigen::Vector3d* position;
  const LiveModel* live;

  bool operator<(const Candidate& o) const {
    return squared_distance != o.squared_distance ? squared_distance < o.squared_distance : key < o.key;
  }
};

struct BrickValue {
  encoding::BrickKind kind = encoding::BrickKind::kOutside;
  encoding::Coefficients values{};  ///< of a stored one
};

/// first        index coordinates of its first place
/// size         of the grid: the body ends at the third layer from its border
/// candidates   in order: all that are within `blend` of a place and among the nine nearest of it. Others that come in between do not matter
/// returns      distances, rounded to 1/4096 voxel and clamped to ±band, and the kind that they make
BrickValue brick_value(const Eigen::Vector3i& first, const Eigen::Vector3i& size, const Reach& reach,
                       std::span<const Candidate> candidates);

}  // namespace isotouch::live
