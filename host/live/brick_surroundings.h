/// A brick of a live field with two rings of values around it, and who is around whom.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "host/encoding/apron.h"
#include "host/encoding/certificate.h"
#include "host/live/nodes.h"

namespace isotouch::live {

class BrickSurroundings {
 public:
  /// node    its bricks are asked for; it and `nodes` stay unchanged
  /// band    half width, voxels with 12 fraction bits
  BrickSurroundings(const Node& node, const Nodes& nodes, std::int16_t band);

  /// Distances, voxels: every one is known, for constant bricks count as what they are.
  encoding::Surroundings of(std::size_t brick) const;

 private:
  std::array<const Node*, 27> nodes_;
  encoding::Coefficients outside_, inside_;
};

/// The brick with one ring.
encoding::Apron apron_of(const encoding::Surroundings& surroundings);
/// The brick alone.
encoding::Samples samples_of(const encoding::Surroundings& surroundings);

/// Marks the bricks of a node in `changed`, and all that touch one of them, as stale.
void mark_around(const Node& node, NodeMask changed, const Nodes& nodes);

}  // namespace isotouch::live
