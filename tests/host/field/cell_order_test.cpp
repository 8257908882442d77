#include "host/field/cell_order.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <set>

#include "host/cloud/random.h"

namespace isotouch::field {
namespace {

using Eigen::Vector3d;

std::vector<Vector3d> scattered(std::size_t count, double size) {
  cloud::Random random(11);
  std::vector<Vector3d> positions;
  for (std::size_t i = 0; i < count; ++i) {
    const double x = random.uniform(-size, size), y = random.uniform(-size, size);
    positions.emplace_back(x, y, random.uniform(-size, size));
  }
  return positions;
}

std::array<double, 3> corner(const Vector3d& position, int level) {
  const double edge = std::ldexp(1.0, level);
  return {std::floor(position.x() / edge), std::floor(position.y() / edge), std::floor(position.z() / edge)};
}

TEST(CellOrder, EveryCellIsOneRunThatHoldsItsPointsInTheirOrder) {
  const auto positions = scattered(5000, 40.0);
  const CellOrder order(positions);
  for (const int level : {0, 1, 3, 6}) {
    std::set<std::array<double, 3>> seen;
    std::uint32_t end = 0;
    for (const Cell& cell : order.cells(level)) {
      ASSERT_EQ(cell.first, end);
      ASSERT_LT(cell.first, cell.last);
      EXPECT_TRUE(seen.insert(corner(positions[order[cell.first]], level)).second) << level;
      for (std::uint32_t n = cell.first + 1; n < cell.last; ++n) {
        EXPECT_EQ(corner(positions[order[n]], level), corner(positions[order[n - 1]], level));
        if (level == 0) {
          EXPECT_LT(order[n - 1], order[n]);
        }
      }
      end = cell.last;
    }
    EXPECT_EQ(end, positions.size());
  }
}

TEST(CellOrder, CutsACellIntoTheCellsInIt) {
  const CellOrder order(scattered(3000, 40.0));
  std::vector<Cell> parts;
  for (const Cell& cell : order.cells(5)) order.cut(cell, 2, parts);
  const auto cells = order.cells(2);
  ASSERT_EQ(parts.size(), cells.size());
  for (std::size_t c = 0; c < cells.size(); ++c) {
    EXPECT_EQ(parts[c].first, cells[c].first);
    EXPECT_EQ(parts[c].last, cells[c].last);
    EXPECT_EQ(parts[c].level, 2);
  }
}

}  // namespace
}  // namespace isotouch::field
