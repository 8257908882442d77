/// The samples of a band field by number, 64 a brick, and the way from one to the next.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "host/field/band_field.h"

namespace isotouch::field {

/// A step to one of the 26 samples around, and its length, voxels.
struct Step {
  Eigen::Vector3i way;
  float length;
};

inline std::array<Step, 26> steps_around() {
  std::array<Step, 26> steps;
  std::size_t count = 0;
  for (int n = 0; n < 27; ++n) {
    const Eigen::Vector3i way(n % 3 - 1, n / 3 % 3 - 1, n / 9 - 1);
    if (way != Eigen::Vector3i::Zero()) steps[count++] = {way, std::sqrt(static_cast<float>(way.squaredNorm()))};
  }
  return steps;
}

class NumberedSamples {
 public:
  static constexpr std::uint32_t kNone = 0xFFFFFFFF;

  /// bricks    sorted by cell, borrowed
  explicit NumberedSamples(const std::vector<Brick>& bricks) : bricks_(bricks) {
    keys_.reserve(bricks.size());
    for (const Brick& brick : bricks) keys_.push_back(key(brick.cell));
  }

  float distance(std::uint32_t sample) const { return bricks_[sample / 64].distance[sample % 64]; }

  /// The sample at a place of the grid; kNone where no brick is listed.
  std::uint32_t at(const Eigen::Vector3i& place) const {
    const Eigen::Vector3i cell(place.x() >> 2, place.y() >> 2, place.z() >> 2);
    const std::int64_t wanted = key(cell);
    const auto found = std::lower_bound(keys_.begin(), keys_.end(), wanted);
    if (found == keys_.end() || *found != wanted) return kNone;
    return number(static_cast<std::uint32_t>(found - keys_.begin()), place);
  }

  /// The sample a step away, at most 4 along each axis; kNone where no brick is listed.
  std::uint32_t beside(std::uint32_t sample, const Eigen::Vector3i& way) const {
    const std::uint32_t brick = sample / 64;
    const Eigen::Vector3i there =
        Eigen::Vector3i(static_cast<int>(sample & 3), static_cast<int>(sample >> 2 & 3), static_cast<int>(sample >> 4 & 3)) + way;
    if ((there.array() >= 0).all() && (there.array() < 4).all()) return number(brick, there);
    return at(4 * bricks_[brick].cell + there);
  }

 private:
  /// Sorts by z, then y, then x; of cells within ±2^20.
  static std::int64_t key(const Eigen::Vector3i& cell) {
    constexpr std::int64_t kRow = 1 << 21;
    return (cell.z() * kRow + cell.y()) * kRow + cell.x();
  }
  static std::uint32_t number(std::uint32_t brick, const Eigen::Vector3i& place) {
    return 64 * brick + static_cast<std::uint32_t>((place.x() & 3) + 4 * (place.y() & 3) + 16 * (place.z() & 3));
  }

  const std::vector<Brick>& bricks_;
  std::vector<std::int64_t> keys_;  ///< of their cells; side by side, so that a search reads little memory
};

/// On different sides of the surface?
inline bool opposite(float a, float b) { return (a < 0.0F) != (b < 0.0F); }

}  // namespace isotouch::field
