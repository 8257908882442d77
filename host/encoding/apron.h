/// A brick with one ring of samples around it, collected from its neighbours: what every local operation on a band works on.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "host/field/band_field.h"

namespace isotouch::encoding {

using Samples = std::array<float, 64>;  ///< of one brick, x fastest
using Apron = std::array<float, 216>;   ///< 6 samples a side, the brick's own from 1 to 4
using Neighbours =
    std::array<std::uint32_t, 27>;  ///< places in the field's list, the brick's own in the middle, x fastest; kAbsent where there is none

inline constexpr std::uint32_t kAbsent = 0xFFFFFFFF;

constexpr std::size_t sample_number(int x, int y, int z) { return static_cast<std::size_t>((z * 4 + y) * 4 + x); }
constexpr std::size_t apron_number(int x, int y, int z) { return static_cast<std::size_t>(((z + 1) * 6 + y + 1) * 6 + x + 1); }

/// The bricks around every brick of a field, in the field's order.
std::vector<Neighbours> neighbours(const field::BandField& field);

/// The apron of a brick from whatever `samples` holds; samples of absent bricks are NaN.
Apron gather(const std::vector<Samples>& samples, const Neighbours& around);

}  // namespace isotouch::encoding
