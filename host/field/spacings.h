/// How far apart the points of a scan are at a place: what says whether it lies in a gap.
#pragma once

#include <Eigen/Core>
#include <atomic>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "host/field/nearest.h"

namespace isotouch::field {

/// Asked from several threads at once, by more than one judge; each answer is looked up once a point.
class Spacings {
 public:
  /// points    borrowed; at least one
  explicit Spacings(const std::vector<Eigen::Vector3d>& points) : points_(points), tree_(points), known_(points.size()) {
    for (auto& known : known_) known.store(kUnknown, std::memory_order_relaxed);
  }

  /// The point nearest to a place.
  ///
  /// found     room to work in
  Neighbour nearest(const Eigen::Vector3d& place, std::vector<Neighbour>& found) const {
    tree_.nearest(place, 1, found);
    return found[0];
  }

  /// From a point to its sixth neighbour, or to the last of a few.
  double at(std::uint32_t point, std::vector<Neighbour>& found) const {
    double known = known_[point].load(std::memory_order_relaxed);
    if (known != kUnknown) return known;
    tree_.nearest(points_[point], kSixth, found);
    known = std::sqrt(found.back().squared_distance);
    known_[point].store(known, std::memory_order_relaxed);  // whoever else asks finds the same
    return known;
  }

 private:
  static constexpr std::size_t kSixth = 7;  // the point itself is the first
  static constexpr double kUnknown = -1.0;

  const std::vector<Eigen::Vector3d>& points_;
  Nearest tree_;
  mutable std::vector<std::atomic<double>> known_;
};

}  // namespace isotouch::field
