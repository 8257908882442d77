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
  middle_x_ = static_cast<float>(brick & 3) * 4.0F + 1.5F;
  middle_y_ = static_cast<float>(brick >> 2 & 3) * 4.0F + 1.5F;
  middle_z_ = static_cast<float>(brick >> 4) * 4.0F + 1.5F;
  farthest_ = static_cast<float>(reach_.influence() * reach_.influence());
  find(std::min(bound, farthest_));
  choose_nearest();
  if (nearest_.size() == kCounted || bound_ == farthest_) return;
  find(farthest_);
  choose_nearest();
}

/// All that are within the bound of the middle.
void NearSamples::find(float bound) {
  bound_ = bound;
  std::size_t within = 0;
  const std::size_t count = x_.size();
  const float *x = x_.data(), *y = y_.data(), *z = z_.data();
  Away* away = away_.data();
  for (std::size_t n = 0; n < count; ++n) {  // a processor cannot foretell which are near: each is written, and stays where it is
    const float square = squared(x[n] - middle_x_, y[n] - middle_y_, z[n] - middle_z_);
    away[within] = {square, static_cast<std::uint32_t>(n)};
    within += square <= bound ? 1U : 0U;
  }
  found_ = {away, within};
}

std::span<const field::BlendCandidate> NearSamples::candidates() {
  if (within_ > bound_) find(within_);
  candidates_.clear();
  const auto add = [&](std::size_t n) {
    candidates_.push_back({&live_[n]->blended, {x_[n] - middle_x_, y_[n] - middle_y_, z_[n] - middle_z_}});
  };
  for (const Nearest& n : nearest_) add(n.sample);
  for (const Away& a : found_) {
    if (a.square >= ninth_ && a.square <= within_ && (a.square > ninth_ || !is_nearest(a.sample))) add(a.sample);
  }
  return candidates_;
}

bool NearSamples::is_nearest(std::uint32_t sample) const {
  return std::any_of(nearest_.begin(), nearest_.end(), [sample](const Nearest& n) { return n.sample == sample; });
}

/// The nearest of what was found, and how far what matters may lie.
void NearSamples::choose_nearest() {
  nearest_.clear();
  float worst = farthest_;
  for (const Away& a : found_) {
    if (!(a.square < worst)) continue;  // of two at one distance, the first counts
    if (nearest_.size() < kCounted) nearest_.emplace_back();
    std::size_t place = nearest_.size() - 1;
    for (; place > 0 && a.square < nearest_[place - 1].squared_distance; --place) nearest_[place] = nearest_[place - 1];
    nearest_[place] = {a.square, a.sample, live_[a.sample]};
    if (nearest_.size() == kCounted) worst = nearest_.back().squared_distance;
  }
  ninth_ = within_ = farthest_;
  if (nearest_.size() < kCounted) return;
  constexpr float kTwice = 5.1962F;  // from a brick's middle to its corners and back, rounded up
  ninth_ = nearest_.back().squared_distance;
  const float most = std::sqrt(ninth_) + kTwice;
  within_ = std::min(most * most, farthest_);
}

}  // namespace isotouch::live
