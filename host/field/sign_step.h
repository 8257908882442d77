/// Surface that the sign alone draws.
#pragma once

#include <cstddef>

#include "host/field/brick_mask.h"
#include "host/field/sample_masks.h"

namespace isotouch::field {

/// The samples from which the sign changes to the next one along an axis of the brick, though each of the two is half a voxel and more from the surface. A
/// distance does not do that: it falls towards the surface. No point stands for what is there; many points together decided the sign on both sides.
static inline BrickMask sign_steps(const BrickSamples& distance) {
  const BrickMask inside = inside_of(distance);
  const BrickMask away = ~samples_that(distance, [](Four d) { return magnitude(d) < 0.5F; });
  BrickMask steps = 0;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const BrickMask last = kLowFace[axis] << kAcross[axis];
    steps |= away & away >> kNext[axis] & (inside ^ inside >> kNext[axis]) & ~last;
  }
  return steps;
}

}  // namespace isotouch::field
