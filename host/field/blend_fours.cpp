#include "host/field/blend_lanes.h"

namespace isotouch::field {

std::array<float, 64> blend_by_fours(std::span<const BlendCandidate> candidates, BrickBlend::Doubt& doubt) {
  return blend_blocks(candidates, doubt);
}

BrickReading blend_body_by_fours(std::span<const BlendCandidate> candidates, float reach, float depth) {
  return body_blocks(candidates, reach, depth);
}

BrickReading nearest_distances_by_fours(std::span<const BlendCandidate> candidates) { return nearest_blocks(candidates); }

}  // namespace isotouch::field
