#include "host/live/near_samples.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace isotouch::live {

namespace {
constexpr std::size_t kCounted = field::kBlended + 1;
}

void NearSamples::gather(const Node& node, NodeMask bricks, const Nodes& nodes, const Reach& reach) {
  reach_ = reach;
  x_.clear(), y_.clear(), z_.clear(), live_.clear();
  const Eigen::Array3d first = 4.0 * node.cell.cast<double>().array();
  Eigen::Array3d low = Eigen::Array3d::Constant(16.0), high = Eigen::Array3d::Zero();
  for (NodeMask left = bricks; left != 0; left &= left - 1) {
    const Eigen::Array3d middle = middle_of(node, static_cast<std::size_t>(std::countr_zero(left))).array() - first;
    low = low.min(middle - reach.influence());
    high = high.max(middle + reach.influence());
  }
  nodes.occupied_in_box(first + low, first + high, [&](const Node& other, std::size_t brick) {
    for (const Entry& entry : other.samples[brick]) {
      const Eigen::Array3d at = entry.mean.position.array() - first;
      if (!entry.felt || (at < low).any() || (at > high).any()) continue;
      x_.push_back(static_cast<float>(at.x()));
      y_.push_back(static_cast<float>(at.y()));
      z_.push_back(static_cast<float>(at.z()));
      live_.push_back(entry.live);
    }
  });
  away_.resize(x_.size() + 1);
}

void NearSamples::choose(std::size_t brick, float bound) {
  const float middle_x = static_cast<float>(brick & 3) * 4.0F + 1.5F, middle_y = static_cast<float>(brick >> 2 & 3) * 4.0F + 1.5F,
              middle_z = static_cast<float>(brick >> 4) * 4.0F + 1.5F;
  const auto farthest = static_cast<float>(reach_.influence() * reach_.influence());
  bound = std::min(bound, farthest);
  for (;; bound = farthest) {
    std::size_t within = 0;
    const std::size_t count = x_.size();
    const float *x = x_.data(), *y = y_.data(), *z = z_.data();
    Away* away = away_.data();
    for (std::size_t n = 0; n < count; ++n) {  // a processor cannot foretell which are near: each is written, and stays where it is
      const float square = squared(x[n] - middle_x, y[n] - middle_y, z[n] - middle_z);
      away[within] = {square, static_cast<std::uint32_t>(n)};
      within += square <= bound ? 1U : 0U;
    }
    choose_of({away, within}, farthest);
    if (influence_ <= bound) break;
  }
  candidates_.clear();
  const auto add = [&](std::size_t n) {
    candidates_.push_back({&live_[n]->blended, {x_[n] - middle_x, y_[n] - middle_y, z_[n] - middle_z}});
  };
  for (const Nearest& n : nearest_) add(n.sample);
  for (const Away& a : chosen_) {
    if (a.square >= ninth_ && a.square <= influence_ && (a.square > ninth_ || !is_nearest(a.sample))) add(a.sample);
  }
}

bool NearSamples::is_nearest(std::uint32_t sample) const {
  return std::any_of(nearest_.begin(), nearest_.end(), [sample](const Nearest& n) { return n.sample == sample; });
}

/// The nearest of what was found, and how far what matters may lie.
void NearSamples::choose_of(std::span<const Away> found, float farthest) {
  chosen_ = found;
  nearest_.clear();
  float worst = farthest;
  for (const Away& a : found) {
    if (!(a.square < worst)) continue;  // of two at one distance, the first counts
    if (nearest_.size() < kCounted) nearest_.emplace_back();
    std::size_t place = nearest_.size() - 1;
    for (; place > 0 && a.square < nearest_[place - 1].squared_distance; --place) nearest_[place] = nearest_[place - 1];
    nearest_[place] = {a.square, a.sample, live_[a.sample]};
    if (nearest_.size() == kCounted) worst = nearest_.back().squared_distance;
  }
  const bool enough = nearest_.size() == kCounted;
  ninth_ = enough ? nearest_.back().squared_distance : farthest;
  constexpr float kTwice = 5.1962F;  // twice from a brick's middle to its corners, rounded up
  const float most = std::sqrt(ninth_) + kTwice;
  influence_ = enough ? std::min(most * most, farthest) : farthest;
}

}  // namespace isotouch::live
