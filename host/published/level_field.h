/// The published distance field: whole levels on a dense grid.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "host/field/band_field.h"

namespace isotouch::published {

inline constexpr int kOutsideLevel = 1;   ///< so the paper's text; its equation 4 writes 0
inline constexpr int kDeepestLevel = -7;  ///< deeper nodes are stored as this one; the paper: 5 to 6 levels are enough

/// One number for every node of a grid, x fastest.
template <class T>
struct DenseField {
  field::Grid grid;
  std::vector<T> values;

  DenseField(const field::Grid& of, T value) : grid(of), values(stride(2) * static_cast<std::size_t>(of.size.z()), value) {}

  /// How far apart neighbours along an axis stand in `values`.
  std::size_t stride(int axis) const {
    const auto x = static_cast<std::size_t>(grid.size.x());
    return axis == 0 ? 1 : axis == 1 ? x : x * static_cast<std::size_t>(grid.size.y());
  }
  std::size_t place(int i, int j, int k) const {
    return static_cast<std::size_t>(i) + stride(1) * static_cast<std::size_t>(j) + stride(2) * static_cast<std::size_t>(k);
  }
  T& at(int i, int j, int k) { return values[place(i, j, k)]; }
  T at(int i, int j, int k) const { return values[place(i, j, k)]; }
};

using Indicator = DenseField<std::uint8_t>;  ///< 1 inside, 0 outside
using LevelField = DenseField<std::int8_t>;  ///< 1 outside, 0 on the innermost side of the surface, -1, … -7

}  // namespace isotouch::published
