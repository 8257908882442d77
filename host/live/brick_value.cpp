#include "host/live/brick_value.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <span>

#include "shared/field_view.h"

namespace isotouch::live {

namespace {

using encoding::BrickKind;

/// From a brick's middle to its corners.
const double kBrickReach = 1.5 * std::sqrt(3.0);

/// By how much a value changes a voxel, at most, where a brick is left out because its middle is far outside. Behind the surface the models' own slope
/// will do: a place that is a little less than the band deep then counts as that deep.
constexpr double kSlope = 1.25, kSlopeBehind = 1.0;

/// The blended distance at the brick's middle, and the brick's value there.
struct Middle {
  double blend, value;
};

/// By the formulas of the blend, in doubles: enough to leave out what is far outside or deep inside.
Middle middle_value(const Eigen::Vector3d& middle, const Reach& reach, std::span<const NearSamples::Nearest> nearest) {
  const double farthest = reach.blend * reach.blend;
  const double border =
      nearest.size() > field::kBlended ? std::min(static_cast<double>(nearest[field::kBlended].squared_distance), farthest) : farthest;
  double sum = 0.0, body = 0.0, weights = 0.0;
  for (std::size_t k = 0; k < std::min(nearest.size(), field::kBlended); ++k) {
    const double share = 1.0 - static_cast<double>(nearest[k].squared_distance) / border;
    if (!(share > 0.0)) break;
    const double weight = nearest[k].live->model.trust * (share * share) * (share * share);
    sum += weight * nearest[k].live->model.distance(middle);
    body += weight * static_cast<double>(nearest[k].live->blended.body);
    weights += weight;
  }
  if (!(weights > 0.0)) return {0.0, 0.0};  // not known: the places are computed
  const double away = std::sqrt(static_cast<double>(nearest.front().squared_distance)), blend = sum / weights, side = body / weights;
  const double behind = away > 0.0 ? std::clamp(-blend / std::min(away, reach.band), 0.0, 1.0) : 0.0;
  return {blend, std::max(blend, away - side - (reach.depth - side) * behind)};
}

constexpr float kScale = 1 << Distance::kFractionBits;

/// To the nearest 1/4096, without a call of the library: processors round many at once.
///
/// distance  within ±8
std::int16_t rounded(float distance) {
  constexpr int kAbove = 8 << Distance::kFractionBits;
  return static_cast<std::int16_t>(static_cast<std::int32_t>(distance * kScale + (kAbove + 0.5F)) - kAbove);
}

/// The body ends before the border: its distance counts where it is larger.
void close(const Eigen::Vector3i& first, const Eigen::Vector3i& size, float band, std::array<float, 64>& distance) {
  for (int n = 0; n < 64; ++n) {
    const Eigen::Array3i place = first.array() + Eigen::Array3i(n & 3, n >> 2 & 3, n >> 4);
    const int layers = std::min(place.minCoeff(), (size.array() - 1 - place).minCoeff());  // to the outermost one
    float& value = distance[static_cast<std::size_t>(n)];
    value = std::max(value, band + 1.0F - static_cast<float>(layers));
  }
}

}  // namespace

BrickValue brick_value(const Eigen::Vector3i& first, const Eigen::Vector3i& size, const Reach& reach, NearSamples& near) {
  BrickValue result;
  result.influence = near.influence();
  if (near.nearest().empty()) return result;
  const Eigen::Vector3d middle = first.cast<double>() + Eigen::Vector3d::Constant(1.5);
  const Middle at_middle = middle_value(middle, reach, near.nearest());
  if (at_middle.value > reach.band + kSlope * kBrickReach) return result;
  const auto depth = static_cast<float>(reach.depth);
  field::BrickReading places;
  std::array<float, 64>& distance = places.distance;
  if (at_middle.blend < -reach.band - kSlopeBehind * kBrickReach) {  // all places are straight behind their nearest sample
    places = field::nearest_distances(near.candidates());
    for (float& d : distance) d -= depth;
  } else {
    places = field::blend_body(near.candidates(), static_cast<float>(reach.blend), depth);
  }
  result.influence = std::max(result.influence, places.influence);
  const auto band = static_cast<float>(reach.band);
  const int closing = static_cast<int>(std::ceil(2.0 * reach.band)) + 2;  // layers in which the border's distance may be above -band
  if ((first.array() < closing).any() || (first.array() + 4 > size.array() - closing).any()) close(first, size, band, distance);

  for (float& d : distance) d = d < -band ? -band : d > band ? band : d;
  for (std::size_t n = 0; n < 64; ++n) result.values[n] = rounded(distance[n]);
  std::int16_t least = result.values[0], largest = result.values[0];
  for (const std::int16_t value : result.values) least = std::min(least, value), largest = std::max(largest, value);
  result.kind = least == rounded(band) ? BrickKind::kOutside : largest == rounded(-band) ? BrickKind::kInside : BrickKind::kStored;
  return result;
}

}  // namespace isotouch::live
