/// Finds a brick of a band field by its cell: the sorted list itself, and where each of its rows begins.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <span>
#include <vector>

#include "host/field/band_field.h"

namespace isotouch::encoding {

class BrickRows {
 public:
  /// field     bricks sorted by cell, each within the grid; stays alive and unchanged
  explicit BrickRows(const field::BandField& field);

  /// Bricks along each axis.
  const Eigen::Vector3i& size() const { return size_; }
  /// The bricks of one row, by rising x; empty outside the grid.
  std::span<const field::Brick> row(int y, int z) const;
  /// The place of `cell` in the field's list, or kAbsent.
  std::size_t find(const Eigen::Vector3i& cell) const;

  /// The place of a brick that `row` gave.
  std::size_t place(const field::Brick& brick) const { return static_cast<std::size_t>(&brick - bricks_.data()); }

  static constexpr std::size_t kAbsent = static_cast<std::size_t>(-1);

 private:
  const std::vector<field::Brick>& bricks_;
  Eigen::Vector3i size_;
  std::vector<std::size_t> begin_;  // of row y + size.y * z; one more at the end
};

}  // namespace isotouch::encoding
