#include "host/encoding/brick_rows.h"

#include <algorithm>

namespace isotouch::encoding {

namespace {
std::size_t row_number(const Eigen::Vector3i& size, int y, int z) {
  return static_cast<std::size_t>(z) * static_cast<std::size_t>(size.y()) + static_cast<std::size_t>(y);
}
}  // namespace

BrickRows::BrickRows(const field::BandField& field) : bricks_(field.bricks), size_((field.grid.size.array() + 3) / 4) {
  begin_.assign(row_number(size_, 0, size_.z()) + 1, 0);
  for (const field::Brick& brick : bricks_) ++begin_[row_number(size_, brick.cell.y(), brick.cell.z()) + 1];
  for (std::size_t row = 1; row < begin_.size(); ++row) begin_[row] += begin_[row - 1];
}

std::span<const field::Brick> BrickRows::row(int y, int z) const {
  if (y < 0 || y >= size_.y() || z < 0 || z >= size_.z()) return {};
  const std::size_t number = row_number(size_, y, z);
  return std::span(bricks_).subspan(begin_[number], begin_[number + 1] - begin_[number]);
}

std::size_t BrickRows::find(const Eigen::Vector3i& cell) const {
  const auto bricks = row(cell.y(), cell.z());
  const auto at = std::lower_bound(bricks.begin(), bricks.end(), cell.x(), [](const field::Brick& b, int x) { return b.cell.x() < x; });
  if (at == bricks.end() || at->cell.x() != cell.x()) return kAbsent;
  return place(*at);
}

}  // namespace isotouch::encoding
