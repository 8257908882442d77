#include "host/cloud/same_place.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <numeric>
#include <tuple>

namespace isotouch::cloud {
namespace {

using Eigen::Vector3d;

constexpr double kOnePlace =
    1e-6;  // of the size of the object: in a dense real scan of 120,000 points the nearest two are 105 times as far apart

/// The largest distance of two points at one place. The middle half of the points says how large the object is, whatever strays there are.
double one_place(const std::vector<Vector3d>& positions) {
  double longest = 0.0;
  std::vector<double> along(positions.size());
  for (Eigen::Index axis = 0; axis < 3; ++axis) {
    std::transform(positions.begin(), positions.end(), along.begin(), [axis](const Vector3d& p) { return p[axis]; });
    const auto quantile = [&](std::size_t fourths) {
      const auto at = along.begin() + static_cast<std::ptrdiff_t>(fourths * (along.size() - 1) / 4);
      std::nth_element(along.begin(), at, along.end());
      return *at;
    };
    longest = std::max(longest, quantile(3) - quantile(1));
  }
  return kOnePlace * longest;
}

bool before(const Vector3d& p, const Vector3d& q) { return std::tie(p.x(), p.y(), p.z()) < std::tie(q.x(), q.y(), q.z()); }

/// A cell with points in it.
struct Cell {
  Vector3d at;
  std::uint32_t first;  ///< of its points
};

/// The row of cells along z that lies beside a cell's own, and how far it was searched. Cells are asked in their order, so that a search only goes on.
struct Row {
  double x, y;  ///< from the cell
  std::size_t next = 0;
};

/// Joins cells that a border parts although their first points are at one place. `place` has the cell itself for each cell, and gets the one it joins.
void join_over_borders(const std::vector<Vector3d>& positions, double size, const std::vector<Cell>& cells,
                       std::vector<std::uint32_t>& place) {
  std::array<Row, 5> rows = {{{-1, -1}, {-1, 0}, {-1, 1}, {0, -1}, {0, 0}}};
  for (std::uint32_t c = 0; c < cells.size(); ++c) {
    for (Row& row : rows) {
      const Vector3d low = cells[c].at + Vector3d(row.x, row.y, -1), high = cells[c].at + Vector3d(row.x, row.y, 1);
      while (row.next < c && before(cells[row.next].at, low)) ++row.next;
      for (std::size_t other = row.next; other < c && !before(high, cells[other].at); ++other) {
        if (place[other] != other) continue;  // only to a place's own first cell: a place does not grow from cell to cell
        if ((positions[cells[c].first] - positions[cells[other].first]).squaredNorm() <= size * size) place[c] = place[other];
      }
    }
  }
}

}  // namespace

std::vector<std::uint32_t> first_at_place(const std::vector<Vector3d>& positions, double at_least) {
  std::vector<Vector3d> cell_of = positions;  // where all points are at one place, each position is a cell
  const double size = std::max(at_least, one_place(positions));
  if (size > 0.0) {
    for (Vector3d& p : cell_of) p = (p / size).array().floor();
  }
  std::vector<std::uint32_t> order(positions.size());
  std::iota(order.begin(), order.end(), 0U);
  std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
    const Vector3d &p = cell_of[a], &q = cell_of[b];
    return std::tie(p.x(), p.y(), p.z(), a) < std::tie(q.x(), q.y(), q.z(), b);
  });
  std::vector<Cell> cells;
  std::vector<std::uint32_t> own(positions.size());  // each point's cell
  for (const std::uint32_t i : order) {
    if (cells.empty() || cells.back().at != cell_of[i]) cells.push_back({cell_of[i], i});
    own[i] = static_cast<std::uint32_t>(cells.size() - 1);
  }
  std::vector<std::uint32_t> place(cells.size());
  std::iota(place.begin(), place.end(), 0U);
  if (size > 0.0) join_over_borders(positions, size, cells, place);
  std::vector<std::uint32_t> first(cells.size(), UINT32_MAX);
  for (std::size_t c = 0; c < cells.size(); ++c) first[place[c]] = std::min(first[place[c]], cells[c].first);
  std::vector<std::uint32_t> result(positions.size());
  std::transform(own.begin(), own.end(), result.begin(), [&](std::uint32_t c) { return first[place[c]]; });
  return result;
}

}  // namespace isotouch::cloud
