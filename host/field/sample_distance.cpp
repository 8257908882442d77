#include "host/field/sample_distance.h"

#include <algorithm>
#include <cmath>

namespace isotouch::field {

namespace {

/// Visits a box of `size` bricks from `first` by eights, and leaves out every part that is farther from the surface than the band.
void visit(const std::function<double(const Eigen::Vector3d&)>& distance, BandField& field, const Eigen::Vector3i& first, int size) {
  const Grid& grid = field.grid;
  if (((4 * first).array() >= grid.size.array()).any()) return;
  const double half = (4 * size - 1) / 2.0;
  const Eigen::Vector3d centre = grid.origin + grid.edge * ((4 * first).cast<double>() + Eigen::Vector3d::Constant(half));
  if (std::abs(distance(centre)) / grid.edge > field.band + half * std::sqrt(3.0) + 1e-6) return;
  if (size > 1) {
    for (int n = 0; n < 8; ++n) visit(distance, field, first + size / 2 * Eigen::Vector3i(n & 1, (n >> 1) & 1, n >> 2), size / 2);
    return;
  }
  Brick brick{first, {}};
  for (int n = 0; n < 64; ++n) {
    const Eigen::Vector3i sample = 4 * first + Eigen::Vector3i(n & 3, (n >> 2) & 3, n >> 4);
    brick.distance[static_cast<std::size_t>(n)] = static_cast<float>(distance(grid.position(sample)) / grid.edge);
  }
  const auto in_band = [&](float d) { return std::abs(static_cast<double>(d)) <= field.band; };
  if (std::any_of(brick.distance.begin(), brick.distance.end(), in_band)) field.bricks.push_back(brick);
}

}  // namespace

BandField sample_distance(const std::function<double(const Eigen::Vector3d&)>& distance, const Grid& grid, double band) {
  BandField field;
  field.grid = grid;
  field.band = band;
  int size = 1;
  while (4 * size < grid.size.maxCoeff()) size *= 2;
  visit(distance, field, Eigen::Vector3i::Zero(), size);
  std::sort(field.bricks.begin(), field.bricks.end(), [](const Brick& a, const Brick& b) { return sort_key(a.cell) < sort_key(b.cell); });
  return field;
}

}  // namespace isotouch::field
