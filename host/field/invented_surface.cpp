#include "host/field/invented_surface.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>

#include "host/field/brick_gradient.h"
#include "host/field/parallel.h"
#include "host/field/sample_masks.h"
#include "host/field/sign_step.h"
#include "host/field/unseen_share.h"

namespace isotouch::field {

namespace {

using Eigen::Vector3d;
using Eigen::Vector3i;

/// A brick beside which the surface passes, less than a voxel away, or through which the sign alone draws one.
struct Crossed {
  std::size_t brick;
  Vector3d place;  ///< its sample nearest to the surface, mm
  Vector3d outward;
  double area;  ///< square voxels of surface: as much as each sample is nearer than a voxel, and a whole one for a step of the sign
};

std::vector<Crossed> crossed_bricks(const BandField& field) {
  std::vector<Crossed> crossed;
  for (std::size_t b = 0; b < field.bricks.size(); ++b) {
    const Brick& brick = field.bricks[b];
    const bool is_near = samples_that(brick.distance, [](Four d) { return magnitude(d) < 1.0F; }) != 0;
    const BrickMask steps = sign_steps(brick.distance);
    if (!is_near && steps == 0) continue;
    double area = 0.0;
    int nearest = 0;
    float least = std::numeric_limits<float>::max();
    for (int s = 0; s < 64; ++s) {
      const float away = (steps >> s & 1) != 0 ? 0.0F : std::abs(brick.distance[static_cast<std::size_t>(s)]);
      area += std::max(0.0, 1.0 - static_cast<double>(away));
      if (away < least) least = away, nearest = s;
    }
    if (area > 0.0) {
      crossed.push_back({b, field.grid.position(4 * brick.cell + Vector3i(nearest & 3, nearest >> 2 & 3, nearest >> 4)),
                         gradient_at(brick, nearest), area});
    }
  }
  return crossed;
}

}  // namespace

InventedSurface invented_surface(const BandField& field, const SoundScan& sound, const Spacings& spacings) {
  const std::vector<Crossed> crossed = crossed_bricks(field);
  std::vector<std::uint8_t> invented(crossed.size());
  in_parallel(crossed.size(), 64, [&](std::size_t begin, std::size_t end) {
    std::vector<Neighbour> found;
    for (std::size_t i = begin; i < end; ++i) {
      const auto nearest = spacings.nearest(crossed[i].place, crossed[i].outward, found);
      if (!nearest || nearest->index >= sound.measured) {
        invented[i] = 1;
        continue;
      }
      const double limit = kGap * spacings.at(nearest->index, found) + field.grid.edge;
      invented[i] = nearest->squared_distance > limit * limit ? 1 : 0;
    }
  });
  InventedSurface result;
  double all = 0.0, share = 0.0;
  for (std::size_t i = 0; i < crossed.size(); ++i) {
    all += crossed[i].area;
    if (invented[i] == 0) continue;
    share += crossed[i].area;
    result.cells.push_back(field.bricks[crossed[i].brick].cell);
  }
  if (all > 0.0) result.share = share / all;
  return result;
}

}  // namespace isotouch::field
