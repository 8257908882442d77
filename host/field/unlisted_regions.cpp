#include "host/field/unlisted_regions.h"

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <tuple>

namespace isotouch::field {

UnlistedRegions::UnlistedRegions(const BandField& field) : size_((field.grid.size + Eigen::Vector3i::Constant(3)) / 4) {
  std::vector<std::size_t> row_begin;  // of every row its first run, and their end
  std::size_t next = 0;
  for (int z = 0; z < size_.z(); ++z) {
    for (int y = 0; y < size_.y(); ++y) {
      row_begin.push_back(runs_.size());
      int first = 0;
      for (; next < field.bricks.size() && field.bricks[next].cell.z() == z && field.bricks[next].cell.y() == y; ++next) {
        const int x = field.bricks[next].cell.x();
        if (x > first) runs_.push_back({z, y, first, x - 1, 0});
        first = x + 1;
      }
      if (first < size_.x()) runs_.push_back({z, y, first, size_.x() - 1, 0});
    }
  }
  row_begin.push_back(runs_.size());

  std::vector<std::uint32_t> parent(runs_.size() + 1);  // the last one is the outer region
  std::iota(parent.begin(), parent.end(), 0U);
  const auto outer = static_cast<std::uint32_t>(runs_.size());
  const auto root = [&](std::uint32_t run) {
    while (parent[run] != run) run = parent[run] = parent[parent[run]];
    return run;
  };
  const auto join = [&](std::uint32_t a, std::uint32_t b) {
    a = root(a), b = root(b);
    parent[std::min(a, b)] = std::max(a, b);
  };
  const auto join_rows = [&](std::size_t row, std::size_t other) {
    std::size_t a = row_begin[row], b = row_begin[other];
    while (a < row_begin[row + 1] && b < row_begin[other + 1]) {
      if (runs_[a].first <= runs_[b].last && runs_[b].first <= runs_[a].last)
        join(static_cast<std::uint32_t>(a), static_cast<std::uint32_t>(b));
      runs_[a].last < runs_[b].last ? ++a : ++b;
    }
  };
  const auto rows = static_cast<std::size_t>(size_.y());
  for (std::size_t row = 0; row + 1 < row_begin.size(); ++row) {
    if (row % rows != 0) join_rows(row, row - 1);
    if (row >= rows) join_rows(row, row - rows);
  }
  for (std::uint32_t n = 0; n < runs_.size(); ++n) {
    const Run& run = runs_[n];
    if (run.first == 0 || run.last == size_.x() - 1 || run.y == 0 || run.y == size_.y() - 1 || run.z == 0 || run.z == size_.z() - 1)
      join(n, outer);
  }
  std::vector<std::uint32_t> number(parent.size(), kOuter);
  for (std::uint32_t n = outer; n-- > 0;) {
    if (root(n) == n) number[n] = count_++;
  }
  for (std::uint32_t n = 0; n < outer; ++n) runs_[n].region = number[root(n)];
}

std::uint32_t UnlistedRegions::of(const Eigen::Vector3i& cell) const {
  if ((cell.array() < 0).any() || (cell.array() >= size_.array()).any()) return kOuter;
  const auto found = std::upper_bound(runs_.begin(), runs_.end(), cell, [](const Eigen::Vector3i& c, const Run& run) {
    return std::tuple(c.z(), c.y(), c.x()) < std::tuple(run.z, run.y, run.first);
  });
  return (found - 1)->region;
}

}  // namespace isotouch::field
