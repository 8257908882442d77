#include "host/published/levels.h"

#include <utility>

namespace isotouch::published {

namespace {

bool has_outside_neighbour(const Indicator& inside, int i, int j, int k) {
  const Eigen::Vector3i& size = inside.grid.size;
  if (i == 0 || j == 0 || k == 0 || i == size.x() - 1 || j == size.y() - 1 || k == size.z() - 1) return true;
  return inside.at(i - 1, j, k) == 0 || inside.at(i + 1, j, k) == 0 || inside.at(i, j - 1, k) == 0 || inside.at(i, j + 1, k) == 0 ||
         inside.at(i, j, k - 1) == 0 || inside.at(i, j, k + 1) == 0;
}

}  // namespace

LevelField peel(Indicator inside, field::Progress& progress) {
  LevelField levels(inside.grid, kOutsideLevel);
  for (std::size_t n = 0; n < levels.values.size(); ++n) {
    if (inside.values[n] != 0) levels.values[n] = kDeepestLevel;
  }
  const Eigen::Vector3i& size = inside.grid.size;
  for (int level = 0; level > kDeepestLevel; --level) {
    Indicator rest = inside;  // a layer is found in one state of the labels, then taken off
    for (int k = 0; k < size.z(); ++k) {
      for (int j = 0; j < size.y(); ++j) {
        for (int i = 0; i < size.x(); ++i) {
          if (inside.at(i, j, k) == 0 || !has_outside_neighbour(inside, i, j, k)) continue;
          levels.at(i, j, k) = static_cast<std::int8_t>(level);
          rest.at(i, j, k) = 0;
        }
      }
    }
    inside = std::move(rest);
    progress.report((1.0 - level) / (1.0 - kDeepestLevel));
  }
  return levels;
}

}  // namespace isotouch::published
