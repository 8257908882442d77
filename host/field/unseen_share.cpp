#include "host/field/unseen_share.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstddef>

#include "host/field/brick_gradient.h"
#include "host/field/parallel.h"
#include "host/field/sample_masks.h"
#include "host/field/sign_step.h"

namespace isotouch::field {

namespace {

using Eigen::Vector3d;
using Eigen::Vector3i;

constexpr std::size_t kStep = 16;

struct Place {
  Vector3d position;  ///< mm
  Vector3d outward;
};

std::vector<Place> beside_surface(const BandField& field, Showing showing) {
  const bool any_side = showing == Showing::kAny;
  std::vector<Place> places;
  std::size_t beside = 0;
  for (const Brick& brick : field.bricks) {
    const BrickMask near = samples_that(brick.distance, [](Four d) { return magnitude(d) < 0.5F; });
    const BrickMask passed = any_side ? near : near | sign_steps(brick.distance);
    for (int s = 0; s < 64; ++s) {
      if ((passed >> s & 1) == 0 || beside++ % kStep != 0) continue;
      places.push_back({field.grid.position(4 * brick.cell + Vector3i(s & 3, s >> 2 & 3, s >> 4)),
                        any_side ? Vector3d(Vector3d::Zero()) : gradient_at(brick, s)});
    }
  }
  return places;
}

}  // namespace

double unseen_share(const BandField& field, const Spacings& spacings, double limit, Showing showing) {
  const std::vector<Place> places = beside_surface(field, showing);
  if (places.empty()) return 0.0;
  std::atomic<std::size_t> unseen = 0;
  in_parallel(places.size(), 64, [&](std::size_t begin, std::size_t end) {
    std::vector<Neighbour> found;
    std::size_t count = 0;
    for (std::size_t i = begin; i < end; ++i) {
      const auto nearest = spacings.nearest(places[i].position, places[i].outward, found);
      if (!nearest) {
        ++count;
        continue;
      }
      const double away = std::sqrt(nearest->squared_distance);
      if (away <= field.grid.edge) continue;
      count += away > limit * spacings.at(nearest->index, found) + field.grid.edge ? 1U : 0U;
    }
    unseen += count;
  });
  return static_cast<double>(unseen) / static_cast<double>(places.size());
}

}  // namespace isotouch::field
