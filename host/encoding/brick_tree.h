/// The field's look-up tree (SPEC.md 2.2): every cell of the grid, stored or not, leads to a brick number.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "host/encoding/brick_rows.h"

namespace isotouch::encoding {

struct BrickTree {
  std::vector<std::uint32_t> root;   ///< node numbers, x fastest
  std::vector<std::uint32_t> nodes;  ///< 64 brick numbers each; node 0 far outside, node 1 far inside
  std::vector<std::size_t> stored;   ///< which brick of the field is brick 2, 3, …: the bricks of a node lie together
};

/// The numbers that a brick of the field may already have; every other one gets a number of its own.
enum class BrickKind : std::uint32_t { kOutside = 0, kInside = 1, kStored = 2 };

/// A cell without a brick has the sign of the samples that face it from the nearest brick before it in its row, and is outside where there
/// is none: between them nothing can change sign without coming within the band, and a row begins at the border, which is outside.
///
/// rows      of the field
/// kinds     one for each brick of the field
BrickTree brick_tree(const BrickRows& rows, const std::vector<BrickKind>& kinds);

}  // namespace isotouch::encoding
