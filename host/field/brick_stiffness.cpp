#include "host/field/brick_stiffness.h"

#include <algorithm>
#include <cstddef>

#include "host/field/parallel.h"

namespace isotouch::field {

namespace {

constexpr std::size_t kSamples = 8;
constexpr std::size_t kGrain = 64;  // bricks a thread takes at once

/// Of samples that all have the largest value, the mean is that value, whatever its last bit would be.
double weighted_mean(const std::vector<Neighbour>& near, const std::vector<double>& stiffness) {
  double sum = 0.0, weights = 0.0;
  double low = stiffness[near.front().index], high = low;
  for (const Neighbour& sample : near) {
    const double weight = 1.0 / (1.0 + sample.squared_distance), value = stiffness[sample.index];
    sum += weight * value;
    weights += weight;
    low = std::min(low, value);
    high = std::max(high, value);
  }
  return std::clamp(sum / weights, low, high);
}

}  // namespace

std::vector<double> brick_stiffness(const std::vector<Brick>& bricks, const std::vector<double>& stiffness, const Nearest& samples) {
  std::vector<double> means(bricks.size());
  in_parallel(bricks.size(), kGrain, [&](std::size_t begin, std::size_t end) {
    std::vector<Neighbour> near;
    for (std::size_t b = begin; b < end; ++b) {
      samples.nearest(4.0 * bricks[b].cell.cast<double>() + Eigen::Vector3d::Constant(1.5), kSamples, near);
      means[b] = weighted_mean(near, stiffness);
    }
  });
  return means;
}

}  // namespace isotouch::field
