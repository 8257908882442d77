/// Which bricks of a band field lie side by side.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "host/field/band_field.h"
#include "host/field/brick_mask.h"

namespace isotouch::field {

inline constexpr std::uint32_t kNoBrick = 0xFFFFFFFF;

/// Of every brick the one that follows it along each axis, kNoBrick where there is none.
using Following = std::vector<std::array<std::uint32_t, 3>>;

/// bricks    sorted by cell
Following following(const std::vector<Brick>& bricks);

/// What lies face to face with a set of samples, given brick by brick, and the set itself.
std::vector<BrickMask> with_neighbours(const std::vector<BrickMask>& sets, const Following& next);

}  // namespace isotouch::field
