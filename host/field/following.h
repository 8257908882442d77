/// Which brick lies beside which.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "host/field/band_field.h"

namespace isotouch::field {

inline constexpr std::uint32_t kNoBrick = 0xFFFFFFFF;

/// Of every brick the one that follows it along each axis, kNoBrick where there is none.
using Following = std::vector<std::array<std::uint32_t, 3>>;

/// bricks    sorted by z, then y, then x
Following following(const std::vector<Brick>& bricks);

}  // namespace isotouch::field
