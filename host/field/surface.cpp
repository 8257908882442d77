#include "host/field/surface.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <utility>

#include "host/field/doubtful_samples.h"

namespace isotouch::field {

namespace {

constexpr double kFarInDoubt = 0.05;  // of the nearest nine's spread, beside doubtful samples

double squared(double x) { return x * x; }

Eigen::Vector3d place(const Eigen::Vector3d& first, std::size_t sample) {
  return first + Eigen::Vector3d(static_cast<double>(sample & 3), static_cast<double>(sample >> 2 & 3), static_cast<double>(sample >> 4));
}

/// Half the diagonal of a brick of 4x4x4 samples.
const double kBrickReach = 1.5 * std::sqrt(3.0);

}  // namespace

Surface::Surface(const Scan& scan, std::vector<LocalModel> models, const Box& closing, double noise, const Doubt& doubt)
    : scan_(scan),
      closing_(closing),
      noisy_(noise > 0.0),
      enclosure_(scan, noise, doubt),
      balls_(empty_balls(scan)),
      models_(std::move(models)),
      level_(scan, noisy_ ? std::vector<std::uint8_t>(scan.size(), 1) : doubtful_samples(scan, models_), enclosure_),
      brick_(scan.positions(), models_, balls_) {}

double Surface::blend(const Eigen::Vector3d& x, std::span<const Neighbour> nearest, bool held) const {
  const std::size_t count = std::min(kBlended, nearest.size());
  // With fewer samples than that the farthest one defines the border.
  const double border = nearest.size() > count ? nearest[count].squared_distance : 2.0 * nearest.back().squared_distance;
  const double scale = border > 0.0 ? 1.0 / border : 0.0;
  const double least = kLeastWeight * squared(squared(1.0 - nearest.front().squared_distance * scale));
  double sum = 0.0, weights = 0.0;
  for (std::size_t k = 0; k < count; ++k) {
    const double nearness = squared(squared(1.0 - nearest[k].squared_distance * scale));
    if (!(nearness > least)) break;
    const auto& model = models_[nearest[k].index];
    const double weight = model.trust * nearness;
    sum += weight * model.distance(x);
    weights += weight;
  }
  // All at one distance: x is the centre of a ball through the samples.
  const double blended = weights > 0.0 ? sum / weights : models_[nearest.front().index].distance(x);
  double distance = held_by_balls(blended, x, nearest.first(count), balls_);
  if (held) {
    distance = level_.hold(distance, x, nearest);
    distance = signed_by_winding(distance, x, nearest.front().squared_distance, border, enclosure_);
  }
  return std::max(distance, closing_.distance(x));
}

double Surface::distance(const Eigen::Vector3d& x) const {
  std::vector<Neighbour> nearest;
  scan_.tree().nearest(x, kBlended + 1, nearest);
  return blend(x, nearest, true);
}

bool Surface::contradicted(bool inside, const Eigen::Vector3d& x, std::span<const Neighbour> nearest) const {
  const double border = nearest[std::min(kBlended, nearest.size() - 1)].squared_distance;
  if (!enclosure_.in_doubt(nearest.front().squared_distance, border)) return false;
  std::size_t behind = 0;
  for (const Neighbour& sample : nearest) behind += scan_.normals()[sample.index].dot(x - scan_.positions()[sample.index]) < 0.0 ? 1U : 0U;
  return (2 * behind > nearest.size()) != inside;
}

bool Surface::hold(const Eigen::Vector3d& first, std::uint64_t places, std::span<const Neighbour> candidates, bool level,
                   std::array<float, 64>& samples) const {
  bool turned = false;
  for (; places != 0; places &= places - 1) {
    const auto s = static_cast<std::size_t>(std::countr_zero(places));
    const Eigen::Vector3d x = place(first, s);
    std::array<Neighbour, kBlended + 1> nearest;  // ascending
    nearest.fill({std::numeric_limits<double>::max(), 0});
    for (const Neighbour& c : candidates) {
      const double square = (scan_.positions()[c.index] - x).squaredNorm();
      if (!(square < nearest.back().squared_distance)) continue;
      std::size_t rank = kBlended;
      for (; rank > 0 && square < nearest[rank - 1].squared_distance; --rank) nearest[rank] = nearest[rank - 1];
      nearest[rank] = {square, c.index};
    }
    auto distance = static_cast<double>(samples[s]);
    if (level) distance = level_.hold(distance, x, nearest);
    const auto held =
        static_cast<float>(signed_by_winding(distance, x, nearest.front().squared_distance, nearest.back().squared_distance, enclosure_));
    turned = turned || (held < 0.0F) != (samples[s] < 0.0F);
    samples[s] = held;
  }
  return turned;
}

BrickDistances Surface::brick(const Eigen::Vector3d& first, double reach) const {
  const Eigen::Vector3d centre = first + Eigen::Vector3d::Constant(1.5);
  thread_local std::vector<Neighbour> candidates;  // keeps its memory
  scan_.tree().nearest_and_beyond(centre, kBlended + 1, 2.0 * kBrickReach, candidates);
  const auto nearest = std::span(candidates).first(std::min(kBlended + 1, candidates.size()));
  const bool doubtful = std::any_of(candidates.begin(), candidates.end(), [&](const Neighbour& c) { return level_.is_doubtful(c.index); });
  BrickDistances result;
  bool astray = false;
  // Beside samples that explain each other the middle's distance would tell nothing that the places' own do not.
  if (doubtful || enclosure_.in_doubt(nearest.front().squared_distance, nearest.back().squared_distance) || candidates.size() <= kBlended) {
    const double free = blend(centre, nearest, false);
    const bool inside = free < 0.0;
    astray = !doubtful && contradicted(inside, centre, nearest);
    result.middle = astray || doubtful ? blend(centre, nearest, true) : free;
    if (doubtful) astray = (result.middle < 0.0) != inside;
    if (std::abs(result.middle) > reach) return result;
  }

  auto& samples = result.samples.emplace();
  if (candidates.size() <= kBlended) {
    for (std::size_t s = 0; s < samples.size(); ++s) samples[s] = static_cast<float>(distance(place(first, s)));
    return result;
  }
  BrickBlend::Doubt doubt{doubtful ? kFarInDoubt : enclosure_.doubt().share};
  samples = brick_(first, candidates, doubt);
  if (doubtful) {
    // In noise every place; otherwise, as that costs time, all of a brick or none.
    const std::uint64_t asked = noisy_ ? ~std::uint64_t{0} : doubt.suspect;
    if (hold(first, asked, candidates, true, samples) || astray) hold(first, ~asked, candidates, true, samples);
  } else if (hold(first, doubt.suspect, candidates, false, samples) || astray) {
    hold(first, doubt.far & ~doubt.suspect, candidates, false, samples);
  }
  result.jumps = astray || doubt.suspect != 0;  // there the whole scan was asked: beside it all of them may be held, or none
  if (closing_.distance(centre) + kBrickReach > static_cast<double>(*std::min_element(samples.begin(), samples.end()))) {
    for (std::size_t s = 0; s < samples.size(); ++s)
      samples[s] = std::max(samples[s], static_cast<float>(closing_.distance(place(first, s))));
  }
  return result;
}

}  // namespace isotouch::field
