/// The space between the bricks of a band field: regions that are wholly inside or wholly outside.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "host/field/band_field.h"

namespace isotouch::field {

/// Cells of the brick grid in which no brick is listed, joined face to face. Work and memory grow with the number of bricks and of rows.
class UnlistedRegions {
 public:
  /// Everything that reaches the border of the grid, and what lies beyond it.
  static constexpr std::uint32_t kOuter = 0;

  explicit UnlistedRegions(const BandField& field);

  std::uint32_t count() const { return count_; }

  /// cell      where no brick is listed; may lie beyond the grid
  std::uint32_t of(const Eigen::Vector3i& cell) const;

 private:
  /// Neighbours in a row without a brick between them.
  struct Run {
    int z, y, first, last;
    std::uint32_t region;
  };

  Eigen::Vector3i size_;
  std::vector<Run> runs_;  ///< sorted by row and place
  std::uint32_t count_ = 1;
};

}  // namespace isotouch::field
