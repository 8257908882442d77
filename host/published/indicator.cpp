#include "host/published/indicator.h"

#include <algorithm>
#include <cmath>

namespace isotouch::published {

namespace {

/// Every node of the sphere's bounding box is tried, as a first program would; `centre` and `radius` in index coordinates.
void mark(Indicator& inside, const Eigen::Vector3d& centre, double radius) {
  const auto first = [&](int axis) { return std::max(0, static_cast<int>(std::ceil(std::max(centre[axis] - radius, 0.0)))); };
  const auto last = [&](int axis) {
    const int end = inside.grid.size[axis] - 1;
    return static_cast<int>(std::floor(std::min(centre[axis] + radius, static_cast<double>(end))));
  };
  const double limit = radius * radius;
  const auto square = [](double value) { return value * value; };
  for (int k = first(2); k <= last(2); ++k) {
    for (int j = first(1); j <= last(1); ++j) {
      const double beside = square(k - centre.z()) + square(j - centre.y());
      std::uint8_t* row = &inside.at(0, j, k);
      for (int i = first(0), end = last(0); i <= end; ++i) {
        if (square(i - centre.x()) + beside <= limit) row[i] = 1;
      }
    }
  }
}

}  // namespace

Indicator nodes_in_spheres(const cloud::OrientedPoints& points, const std::vector<double>& radii, const field::Grid& grid,
                           field::Progress& progress) {
  Indicator inside(grid, 0);
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (!std::isfinite(radii[i])) continue;
    const Eigen::Vector3d centre = points.positions[i] - radii[i] * points.normals[i];
    mark(inside, grid.to_index(centre), radii[i] / grid.edge);
    if (i % 64 == 0) progress.report(static_cast<double>(i) / static_cast<double>(points.size()));
  }
  return inside;
}

}  // namespace isotouch::published
