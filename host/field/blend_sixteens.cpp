#include "host/field/blend_lanes.h"

namespace isotouch::field {

std::array<float, 64> blend_by_sixteens(std::span<const BlendCandidate> candidates, BrickBlend::Doubt& doubt) {
  return blend_blocks(candidates, doubt);
}

}  // namespace isotouch::field
