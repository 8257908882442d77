/// What a sample of a live field says of places near it, and how far that reaches.
#pragma once

#include "host/field/blend_brick.h"
#include "host/field/local_model.h"

namespace isotouch::live {

/// How far things reach, voxels.
struct Reach {
  double band;   ///< half width
  double depth;  ///< behind a sample there is body up to here: twice the band and one, so that a layer of it is far inside
  double blend;  ///< a sample farther away than that says nothing of a place: depth and band

  explicit constexpr Reach(double band_voxels) : band(band_voxels), depth(2.0 * band_voxels + 1.0), blend(depth + band_voxels) {}

  /// From a brick's middle to the farthest sample that may matter to one of its places, rounded up.
  constexpr double influence() const { return blend + 2.5985; }
};

struct LiveModel {
  field::LocalModel model;
  field::BrickBlend::Model blended;  ///< the same for the blend; `body` is how far there is body to the sides
};

}  // namespace isotouch::live
