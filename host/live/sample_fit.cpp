#include "host/live/sample_fit.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <span>
#include <vector>

namespace isotouch::live {

namespace {

constexpr std::size_t kFewestListed = 7;  ///< a sample with fewer, itself among them, is not felt
constexpr double kBodyOfSpacing = 1.25;   ///< a sample's body reaches this many spacings to the sides,
constexpr double kLeastBody = 2.0;        ///< but at least so many voxels

/// A neighbour of a sample.
struct Near {
  double squared_distance;
  const Entry* entry;
};

/// The nearest of all that are added, ascending; of two at one distance, the first.
class NearestFew {
 public:
  explicit NearestFew(double most) : worst_(most) {}
  void add(double squared_distance, const Entry& entry) {
    if (!(squared_distance <= worst_) || (full() && squared_distance == worst_)) return;
    std::size_t place = full() ? count_ - 1 : count_++;
    for (; place > 0 && squared_distance < near_[place - 1].squared_distance; --place) near_[place] = near_[place - 1];
    near_[place] = {squared_distance, &entry};
    if (full()) worst_ = near_[count_ - 1].squared_distance;
  }
  bool full() const { return count_ == near_.size(); }
  std::span<const Near> list() const { return std::span(near_).first(count_); }

 private:
  std::array<Near, field::kModelled> near_{};
  std::size_t count_ = 0;
  double worst_;
};

}  // namespace

SampleFit fit_sample(const Entry& entry, const Nodes& nodes, const Reach& reach_of, LiveModel& live) {
  const Eigen::Vector3d& own = entry.mean.position;
  const auto gather = [&](double radius) {
    NearestFew few(radius * radius);
    nodes.occupied_in_ball(own, radius, [&](const Node& node, std::size_t brick) {
      for (const Entry& other : node.samples[brick]) few.add(field::squared_distance(other.mean.position, own), other);
    });
    return few;
  };
  // Any radius that is large enough gives the same.
  double radius = entry.influence > 0.0 ? std::sqrt(entry.influence) + 0.1 : 4.0;
  NearestFew few = gather(std::min(radius, kModelReach));
  while (!few.full() && radius < kModelReach) few = gather(std::min(radius *= 1.5, kModelReach));
  const std::span<const Near> near = few.list();
  const std::size_t listed = near.size();
  const double reach = few.full() ? near.back().squared_distance : kModelReach * kModelReach;

  SampleFit fit{listed >= kFewestListed, false, reach};
  if (!fit.felt) return fit;
  thread_local std::vector<field::WeightedSample> neighbours;
  neighbours.assign(1, {own, entry.mean.normal, 1.0});
  for (std::size_t n = 0; n < listed && neighbours.size() < field::kModelled - 1; ++n) {
    if (near[n].entry == &entry) continue;
    const Mean& mean = near[n].entry->mean;
    neighbours.push_back({mean.position, mean.normal, std::max(1e-3, 1.0 - near[n].squared_distance / reach)});
  }
  live.model = field::fit_model(neighbours);
  live.blended = field::BrickBlend::model_of(own, live.model);
  const double spacing = std::sqrt(near[kFewestListed - 1].squared_distance);
  live.blended.body = static_cast<float>(std::clamp(kBodyOfSpacing * spacing, kLeastBody, reach_of.depth));
  fit.unexplained = field::is_unexplained(live.model);
  return fit;
}

}  // namespace isotouch::live
