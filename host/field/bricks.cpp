#include "host/field/bricks.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <iterator>

namespace isotouch::field {

namespace {

/// Brick coordinates as one number that sorts by z, then y, then x.
using Key = std::uint64_t;

Key key_of(const Eigen::Vector3i& cell) {
  return static_cast<Key>(cell.z()) << 42 | static_cast<Key>(cell.y()) << 21 | static_cast<Key>(cell.x());
}

Eigen::Vector3i cell_of(Key key) {
  constexpr Key kMask = (Key{1} << 21) - 1;
  return {static_cast<int>(key & kMask), static_cast<int>(key >> 21 & kMask), static_cast<int>(key >> 42)};
}

bool within(const Eigen::Vector3i& cell, const Eigen::Vector3i& cells) {
  return (cell.array() >= 0).all() && (cell.array() < cells.array()).all();
}

void sort_unique(std::vector<Key>& keys) {
  std::sort(keys.begin(), keys.end());
  keys.erase(std::unique(keys.begin(), keys.end()), keys.end());
}

/// Half a brick's diagonal, and as much again for slopes above one where models are blended.
const double kFar = 2.0 * 1.5 * std::sqrt(3.0);

}  // namespace

std::vector<Brick> band_bricks(const std::vector<Eigen::Vector3i>& seeds, const Eigen::Vector3i& cells, double band,
                               const BrickDistances& distances, const PointDistance& at) {
  std::vector<Key> front, visited, next;
  for (const auto& seed : seeds) {
    if (within(seed, cells)) front.push_back(key_of(seed));
  }
  sort_unique(front);
  std::vector<Brick> bricks;
  while (!front.empty()) {
    next.clear();
    for (const Key key : front) {
      Brick brick{cell_of(key), {}};
      if (std::abs(at(4.0 * brick.cell.cast<double>() + Eigen::Vector3d::Constant(1.5))) > band + kFar) continue;
      const auto exact = distances(brick.cell);
      const auto [least, most] = std::minmax_element(exact.begin(), exact.end());
      if (*least > band || *most < -band) continue;
      std::transform(exact.begin(), exact.end(), brick.distance.begin(), [](double d) { return static_cast<float>(d); });
      bricks.push_back(brick);
      for (int axis = 0; axis < 3; ++axis) {
        for (const int step : {-1, 1}) {
          Eigen::Vector3i cell = brick.cell;
          cell[axis] += step;
          if (within(cell, cells)) next.push_back(key_of(cell));
        }
      }
    }
    std::vector<Key> all;
    std::merge(visited.begin(), visited.end(), front.begin(), front.end(), std::back_inserter(all));
    visited.swap(all);
    sort_unique(next);
    front.clear();
    std::set_difference(next.begin(), next.end(), visited.begin(), visited.end(), std::back_inserter(front));
  }
  std::sort(bricks.begin(), bricks.end(), [](const Brick& a, const Brick& b) { return key_of(a.cell) < key_of(b.cell); });
  return bricks;
}

}  // namespace isotouch::field
