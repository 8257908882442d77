/// A brick with one ring of samples around it, collected from its neighbours: what every local operation on a band works on.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <vector>

#include "host/blob/brick_rows.h"

namespace isotouch::blob {

using Samples = std::array<float, 64>;  ///< of one brick, x fastest
using Apron = std::array<float, 216>;   ///< 6 samples a side, the brick's own from 1 to 4
using Neighbours = std::array<std::size_t, 27>;

constexpr std::size_t sample_number(int x, int y, int z) { return static_cast<std::size_t>((z * 4 + y) * 4 + x); }
constexpr std::size_t apron_number(int x, int y, int z) { return static_cast<std::size_t>(((z + 1) * 6 + y + 1) * 6 + x + 1); }

/// The places of the bricks around a cell, itself in the middle; absent ones are BrickRows::kAbsent.
Neighbours neighbours(const BrickRows& rows, const Eigen::Vector3i& cell);

/// The apron of a brick from whatever `samples` holds; samples of absent bricks are NaN.
Apron gather(const std::vector<Samples>& samples, const Neighbours& around);

}  // namespace isotouch::blob
