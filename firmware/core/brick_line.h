/// The bricks of a field that lie in one line along x: what a sampler looks up for the rows of numbers around a point.
#pragma once

#include <cstddef>
#include <cstdint>

#include "shared/field_view.h"

namespace isotouch::core {

/// A line of bricks. The walk from the root to its nodes is made once for all of them.
///
/// tick      yes
class BrickLine {
 public:
  /// y, z     of the line, in bricks; within the grid
  BrickLine(const FieldView& field, std::int32_t y, std::int32_t z)
      : bricks_(field.bricks),
        cells_(field.root + ((z >> 2) * field.root_size[1] + (y >> 2)) * field.root_size[0]),
        slots_(field.nodes + (((z & 3) << 4) | ((y & 3) << 2))) {}

  /// The 64 numbers of the brick at x, in bricks; within the grid.
  const std::int16_t* operator[](std::int32_t x) const {
    using namespace image_layout;
    return bricks_ + slots_[cells_[x >> 2] * kBricksPerNode + static_cast<std::uint32_t>(x & 3)] * kSamplesPerBrick;
  }

 private:
  const std::int16_t* bricks_;
  const std::uint32_t *cells_, *slots_;
};

}  // namespace isotouch::core
