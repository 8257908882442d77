#include "host/vdb/level_set_field.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <vector>

#include "host/field/bricks.h"
#include "host/field/make_grid.h"

namespace isotouch::vdb {

using Eigen::Vector3d;
using Eigen::Vector3i;

field::BandField own_field(const LevelSet& set, cloud::Placement& placement, double band) {
  field::BandField field = *set.samples;
  const field::Grid in_world = field.grid;
  field.band = band;
  field.grid.edge = placement.scale * in_world.edge;
  field.grid.origin = placement.to_workspace(in_world.origin);
  field.grid = field::exact_grid(field.grid);
  placement.scale = field.grid.edge / in_world.edge;
  placement.offset = field.grid.origin - placement.scale * in_world.origin;
  return field;
}

double known_band(const Interpolation& level_set, const LevelSet& set, const cloud::Placement& placement, double edge) {
  return level_set.reach() * set.edge * placement.scale / edge;
}

field::BandField resampled_field(const Interpolation& level_set, const LevelSet& set, const cloud::Placement& placement,
                                 const field::Grid& grid, double band) {
  const double known = known_band(level_set, set, placement, grid.edge);
  const double to_voxels = placement.scale / grid.edge;
  const auto world = [&](const Vector3d& index) { return placement.to_cloud(grid.origin + grid.edge * index); };
  // What is not known counts as just beyond the band at a sample, so that its brick is not listed for it, and as in reach at a middle, so that
  // the walk looks at the samples.
  const auto held = [&](double distance, double unknown) {
    const double d = distance * to_voxels;
    return std::abs(d) < known ? d : std::copysign(unknown, d);
  };
  const auto at = [&](const Vector3d& index) {
    const Vector3d place = world(index);
    double value = 0;
    level_set.distances({&place, 1}, {&value, 1});
    return held(value, band);
  };
  const auto brick = [&](const Vector3i& cell, double reach) {
    field::BrickDistances found{at(4.0 * cell.cast<double>() + Vector3d::Constant(1.5)), std::nullopt};
    if (std::abs(found.middle) > reach) return found;
    std::array<Vector3d, 64> places;
    for (int n = 0; n < 64; ++n)
      places[static_cast<std::size_t>(n)] = world((4 * cell + Vector3i(n & 3, n >> 2 & 3, n >> 4)).cast<double>());
    std::array<double, 64> values{};
    level_set.distances(places, values);
    auto& samples = found.samples.emplace();
    for (std::size_t s = 0; s < samples.size(); ++s) samples[s] = static_cast<float>(held(values[s], band + 1.0));
    return found;
  };
  std::vector<Vector3i> seeds;
  seeds.reserve(set.crossings.size());
  for (const Vector3d& place : set.crossings)
    seeds.emplace_back((grid.to_index(placement.to_workspace(place)) * 0.25).array().floor().cast<int>());
  field::BandField field{grid, band, {}};
  field.bricks = field::band_bricks({at, brick}, (grid.size + Vector3i::Constant(3)) / 4, band, seeds);
  return field;
}

}  // namespace isotouch::vdb
