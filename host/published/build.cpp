#include "host/published/build.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "host/error.h"
#include "host/field/balls.h"
#include "host/published/indicator.h"
#include "host/published/levels.h"

namespace isotouch::published {

Built build(const cloud::OrientedPoints& points, const field::Grid& grid, field::Progress& progress) {
  constexpr double kMaxNodes = 1 << 28;
  if (const double nodes = grid.size.cast<double>().prod(); nodes > kMaxNodes) {
    throw InputError("the published method keeps every node, and this grid has " + std::to_string(static_cast<long long>(nodes)) +
                     ", more than 2^28; choose a larger --voxel or a smaller --grid");
  }
  progress.begin("radii");
  const std::vector<double> radii = field::packing_radii_brute_force(points);
  progress.begin("indicator");
  Indicator inside = nodes_in_spheres(points, radii, grid, progress);
  const auto inside_nodes = std::count(inside.values.begin(), inside.values.end(), 1);
  progress.begin("levels");
  LevelField levels = peel(std::move(inside), progress);
  progress.end();
  const auto without = std::count_if(radii.begin(), radii.end(), [](double r) { return !std::isfinite(r); });
  return {std::move(levels), static_cast<std::size_t>(inside_nodes), static_cast<std::size_t>(without)};
}

field::BandField to_band_field(const LevelField& levels) {
  constexpr float kFarOutside = 1.0F - kDeepestLevel;  // beyond the band
  field::BandField field;
  field.grid = levels.grid;
  field.band = -kDeepestLevel;
  const Eigen::Vector3i size = levels.grid.size;
  const auto distance = [&](const Eigen::Vector3i& sample) {
    const bool border = (sample.array() < 2).any() || (sample.array() >= size.array() - 2).any();
    return border ? kFarOutside : static_cast<float>(levels.at(sample.x(), sample.y(), sample.z()));
  };
  const Eigen::Vector3i bricks = (size.array() + 3) / 4;
  for (int z = 0; z < bricks.z(); ++z) {
    for (int y = 0; y < bricks.y(); ++y) {
      for (int x = 0; x < bricks.x(); ++x) {
        field::Brick brick{{x, y, z}, {}};
        for (int n = 0; n < 64; ++n) {
          brick.distance[static_cast<std::size_t>(n)] = distance(4 * brick.cell + Eigen::Vector3i(n & 3, (n >> 2) & 3, n >> 4));
        }
        field.bricks.push_back(brick);
      }
    }
  }
  return field;
}

}  // namespace isotouch::published
