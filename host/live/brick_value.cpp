#include "host/live/brick_value.h"

#include <algorithm>
#include <cmath>

#include "shared/field_view.h"

namespace isotouch::live {

namespace {

using encoding::BrickKind;

/// From a brick's middle to its corners.
const double kBrickReach = 1.5 * std::sqrt(3.0);

/// By how much a value changes a voxel, as the default method assumes of its blend.
constexpr double kSlope = 1.5;

/// The distance at the brick's middle, by the formulas of the blend, in doubles: enough to leave out what is far outside.
double middle_value(const Eigen::Vector3d& middle, const Reach& reach, std::span<const Candidate> candidates) {
  const double farthest = reach.blend * reach.blend;
  const double border = candidates.size() > field::kBlended ? std::min(candidates[field::kBlended].squared_distance, farthest) : farthest;
  double sum = 0.0, body = 0.0, weights = 0.0;
  for (std::size_t k = 0; k < std::min(candidates.size(), field::kBlended); ++k) {
    const double share = 1.0 - candidates[k].squared_distance / border;
    if (!(share > 0.0)) break;
    const double weight = candidates[k].live->model.trust * (share * share) * (share * share);
    sum += weight * candidates[k].live->model.distance(middle);
    body += weight * static_cast<double>(candidates[k].live->blended.body);
    weights += weight;
  }
  if (!(weights > 0.0)) return -reach.band;  // not known: the places are computed
  const double nearest = std::sqrt(candidates.front().squared_distance), blend = sum / weights, side = body / weights;
  const double behind = nearest > 0.0 ? std::clamp(-blend / std::min(nearest, reach.band), 0.0, 1.0) : 0.0;
  return std::max(blend, nearest - side - (reach.depth - side) * behind);
}

std::int16_t rounded(float distance, float band) {
  return static_cast<std::int16_t>(std::floor(std::clamp(distance, -band, band) * (1 << Distance::kFractionBits) + 0.5F));
}

}  // namespace

BrickValue brick_value(const Eigen::Vector3i& first, const Eigen::Vector3i& size, const Reach& reach,
                       std::span<const Candidate> candidates) {
  BrickValue result;
  if (candidates.empty()) return result;
  const Eigen::Vector3d middle = first.cast<double>() + Eigen::Vector3d::Constant(1.5);
  if (middle_value(middle, reach, candidates) > reach.band + kSlope * kBrickReach) return result;

  thread_local std::vector<field::BlendCandidate> near;  // keeps its memory
  near.clear();
  for (const Candidate& c : candidates) {
    const Eigen::Vector3f own = (*c.position - middle).cast<float>();
    near.push_back({&c.live->blended, {own.x(), own.y(), own.z()}});
  }
  const std::array<float, 64> distance = field::blend_body(near, static_cast<float>(reach.blend), static_cast<float>(reach.depth));

  const auto band = static_cast<float>(reach.band);
  for (std::size_t n = 0; n < 64; ++n) result.values[n] = rounded(distance[n], band);
  const int closing = static_cast<int>(std::ceil(reach.band)) + 2;  // layers in which the border's distance counts
  if ((first.array() < closing).any() || (first.array() + 4 > size.array() - closing).any()) {
    for (int n = 0; n < 64; ++n) {
      const Eigen::Array3i place = first.array() + Eigen::Array3i(n & 3, n >> 2 & 3, n >> 4);
      const int layers = std::min(place.minCoeff(), (size.array() - 1 - place).minCoeff());  // to the outermost one
      auto& value = result.values[static_cast<std::size_t>(n)];
      value = std::max(value, rounded(band + 1.0F - static_cast<float>(layers), band));
    }
  }
  const auto all = [&](float value) {
    return std::all_of(result.values.begin(), result.values.end(), [v = rounded(value, band)](std::int16_t c) { return c == v; });
  };
  result.kind = all(band) ? BrickKind::kOutside : all(-band) ? BrickKind::kInside : BrickKind::kStored;
  return result;
}

}  // namespace isotouch::live
