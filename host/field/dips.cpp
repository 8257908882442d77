#include "host/field/dips.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstddef>

#include "host/field/numbered_samples.h"
#include "host/field/parallel.h"
#include "host/field/sample_masks.h"

namespace isotouch::field {

namespace {

constexpr float kDip = 0.5F;  // voxels
constexpr std::uint32_t kNone = NumberedSamples::kNone;

/// Samples near to zero of which none hangs together with one beside the surface.
std::vector<BrickMask> dips(const std::vector<Brick>& bricks, const Following& next) {
  std::vector<BrickMask> inside(bricks.size(), 0), outside(bricks.size(), 0), near(bricks.size(), 0);
  in_parallel(bricks.size(), 1024, [&](std::size_t begin, std::size_t end) {
    for (std::size_t b = begin; b < end; ++b) {
      inside[b] = inside_of(bricks[b].distance);
      outside[b] = ~inside[b];
      near[b] = samples_that(bricks[b].distance, [](Four d) { return magnitude(d) < kDip; });
    }
  });
  const std::vector<BrickMask> beside_inside = with_neighbours(inside, next), beside_outside = with_neighbours(outside, next);
  std::vector<BrickMask> reached(bricks.size());
  for (std::size_t b = 0; b < bricks.size(); ++b) reached[b] = near[b] & beside_inside[b] & beside_outside[b];
  for (bool more = true; more;) {
    more = false;
    const std::vector<BrickMask> beside = with_neighbours(reached, next);
    for (std::size_t b = 0; b < bricks.size(); ++b) {
      const BrickMask now = near[b] & beside[b];
      more = more || now != reached[b];
      reached[b] = now;
    }
  }
  for (std::size_t b = 0; b < bricks.size(); ++b) near[b] &= ~reached[b];
  return near;
}

/// Removes from a set of samples what hangs together beside at least `kFewestVoices` of the points.
void keep_supported(std::vector<BrickMask>& set, const std::vector<Brick>& bricks, const std::vector<Eigen::Vector3d>& points) {
  const NumberedSamples samples(bricks);
  const auto steps = steps_around();
  std::vector<std::uint32_t> group(64 * bricks.size(), 0);  // 0: not of the set
  std::vector<std::uint32_t> front, voices = {0};
  const auto holds = [&](std::uint32_t sample) { return (set[sample / 64] >> sample % 64 & 1U) != 0; };
  for (std::uint32_t b = 0; b < set.size(); ++b) {
    for (BrickMask rest = set[b]; rest != 0; rest &= rest - 1) {
      const std::uint32_t first = 64 * b + static_cast<std::uint32_t>(std::countr_zero(rest));
      if (group[first] != 0) continue;
      const auto number = static_cast<std::uint32_t>(voices.size());
      voices.push_back(0);
      group[first] = number;
      for (front.assign(1, first); !front.empty();) {
        const std::uint32_t sample = front.back();
        front.pop_back();
        for (const Step& step : steps) {
          const std::uint32_t other = samples.beside(sample, step.way);
          if (other == kNone || !holds(other) || group[other] != 0) continue;
          group[other] = number;
          front.push_back(other);
        }
      }
    }
  }
  for (const Eigen::Vector3d& point : points) {
    const Eigen::Vector3i low = point.array().floor().cast<int>();
    std::uint32_t heard = 0;
    for (int corner = 0; corner < 8 && heard == 0; ++corner) {
      const std::uint32_t sample = samples.at(low + Eigen::Vector3i(corner & 1, corner >> 1 & 1, corner >> 2));
      if (sample != kNone) heard = group[sample];
    }
    ++voices[heard];
  }
  for (std::uint32_t b = 0; b < set.size(); ++b) {
    for (BrickMask rest = set[b]; rest != 0; rest &= rest - 1) {
      const int s = std::countr_zero(rest);
      if (voices[group[64 * b + static_cast<std::uint32_t>(s)]] >= kFewestVoices) set[b] &= ~(BrickMask{1} << s);
    }
  }
}

}  // namespace

std::vector<BrickMask> unsupported_dips(const std::vector<Brick>& bricks, const Following& next,
                                        const std::vector<Eigen::Vector3d>& points) {
  std::vector<BrickMask> found = dips(bricks, next);
  if (std::any_of(found.begin(), found.end(), [](BrickMask set) { return set != 0; })) keep_supported(found, bricks, points);
  return found;
}

}  // namespace isotouch::field
