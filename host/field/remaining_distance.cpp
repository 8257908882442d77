#include "host/field/remaining_distance.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <functional>
#include <queue>
#include <utility>

#include "host/field/numbered_samples.h"

namespace isotouch::field {

namespace {

constexpr std::uint32_t kNone = NumberedSamples::kNone;
constexpr float kShorter = 0.92F;  // a way over such steps is up to 8.2 % longer than the straight one: so it never is
constexpr float kNearest = 0.1F;   // voxels, to a surface that passes between diagonal neighbours

/// The taken samples, and those from which the way to the nearest surface led to them. A 1 a sample.
std::vector<std::uint8_t> lost_samples(const NumberedSamples& samples, const std::vector<BrickMask>& taken, float band,
                                       const std::array<Step, 26>& steps) {
  std::vector<std::uint8_t> lost(64 * taken.size(), 0);
  std::vector<std::uint32_t> front;
  for (std::uint32_t b = 0; b < taken.size(); ++b) {
    for (BrickMask rest = taken[b]; rest != 0; rest &= rest - 1) {
      front.push_back(64 * b + static_cast<std::uint32_t>(std::countr_zero(rest)));
      lost[front.back()] = 1;
    }
  }
  const auto crosses = [&](std::uint32_t sample) {
    return std::any_of(steps.begin(), steps.end(), [&](const Step& step) {
      const std::uint32_t other = step.length > 1.0F ? kNone : samples.beside(sample, step.way);
      return other != kNone && opposite(samples.distance(other), samples.distance(sample));
    });
  };
  while (!front.empty()) {
    const std::uint32_t sample = front.back();
    front.pop_back();
    const bool was_taken = (taken[sample / 64] >> sample % 64 & 1U) != 0;
    const float reached = was_taken ? -1.0F : std::abs(samples.distance(sample));
    for (const Step& step : steps) {
      const std::uint32_t other = samples.beside(sample, step.way);
      if (other == kNone || lost[other] != 0) continue;
      const float here = samples.distance(other);
      if (opposite(here, samples.distance(sample)) || std::abs(here) <= reached || !(std::abs(here) <= band) || crosses(other)) continue;
      lost[other] = 1;
      front.push_back(other);
    }
  }
  return lost;
}

}  // namespace

void restore_distances(BandField& field, const std::vector<BrickMask>& taken) {
  const std::array<Step, 26> steps = steps_around();
  const auto band = static_cast<float>(field.band);
  const NumberedSamples samples(field.bricks);
  const std::vector<std::uint8_t> lost = lost_samples(samples, taken, band, steps);
  std::vector<float> shortest(lost.size(), 2.0F * band);
  using Way = std::pair<float, std::uint32_t>;  // its length, and the sample
  std::priority_queue<Way, std::vector<Way>, std::greater<>> ways;
  const auto offer = [&](std::uint32_t sample, float way) {
    if (!(way < shortest[sample])) return;
    shortest[sample] = way;
    ways.emplace(way, sample);
  };
  for (std::uint32_t sample = 0; sample < lost.size(); ++sample) {
    if (lost[sample] == 0) continue;
    for (const Step& step : steps) {
      const std::uint32_t other = samples.beside(sample, step.way);
      if (other == kNone || lost[other] != 0) continue;
      const float there = samples.distance(other);
      if (std::abs(there) > band) continue;  // beyond the band only its sign is true
      const bool across = opposite(there, samples.distance(sample));
      offer(sample, across ? std::max(kShorter * step.length - std::abs(there), kNearest) : kShorter * step.length + std::abs(there));
    }
  }
  while (!ways.empty()) {
    const auto [way, sample] = ways.top();
    ways.pop();
    if (way > shortest[sample]) continue;
    for (const Step& step : steps) {
      const std::uint32_t other = samples.beside(sample, step.way);
      if (other != kNone && lost[other] != 0) offer(other, way + kShorter * step.length);
    }
  }
  for (std::uint32_t sample = 0; sample < lost.size(); ++sample) {
    if (lost[sample] == 0) continue;
    float& distance = field.bricks[sample / 64].distance[sample % 64];
    const bool was_taken = (taken[sample / 64] >> sample % 64 & 1U) != 0;
    distance = std::copysign(was_taken ? shortest[sample] : std::max(shortest[sample], std::abs(distance)), distance);
  }
}

}  // namespace isotouch::field
