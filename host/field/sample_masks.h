/// Sets of a brick's samples by their distances, four samples at a time.
#pragma once

#include <array>
#include <cstddef>

#include "host/field/brick_mask.h"
#include "host/field/simd.h"

namespace isotouch::field {

using BrickSamples = std::array<float, 64>;

/// The samples for which `holds` says so.
///
/// holds     (Four samples) → comparison of them
template <class Holds>
static inline BrickMask samples_that(const BrickSamples& samples, const Holds& holds) {
  BrickMask mask = 0;
  for (std::size_t n = 0; n < samples.size(); n += 4) mask |= BrickMask{true_lanes(holds(load(&samples[n])))} << n;
  return mask;
}

/// The negative ones.
static inline BrickMask inside_of(const BrickSamples& distance) {
  return samples_that(distance, [](Four d) { return d < 0.0F; });
}

/// The smallest and the largest sample.
struct Extremes {
  float least, largest;
};
static inline Extremes extremes(const BrickSamples& samples) {
  Four low = load(samples.data()), high = low;
  for (std::size_t n = 4; n < samples.size(); n += 4) {
    const Four row = load(&samples[n]);
    low = lesser(row, low);
    high = larger(row, high);
  }
  return {least(low), largest(high)};
}

}  // namespace isotouch::field
