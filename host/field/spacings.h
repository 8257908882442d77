/// Which point of a scan shows a place, and how far apart the points are there: what says whether it lies in a gap.
#pragma once

#include <Eigen/Core>
#include <atomic>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "host/cloud/oriented_points.h"
#include "host/field/nearest.h"

namespace isotouch::field {

/// Asked from several threads at once, by more than one judge; each answer is looked up once a point.
class Spacings {
 public:
  /// points    borrowed; at least one
  explicit Spacings(const cloud::OrientedPoints& points) : points_(points), tree_(points.positions), known_(points.size()) {
    for (auto& known : known_) known.store(kUnknown, std::memory_order_relaxed);
  }

  const cloud::OrientedPoints& points() const { return points_; }

  /// The nearest of the points round a place whose normal looks to the same side as the surface there; nothing where none of a few does. The other side
  /// of a wall is near and shows nothing of this one.
  ///
  /// outward   of the surface; of any length, or zero for any side
  /// found     room to work in
  std::optional<Neighbour> nearest(const Eigen::Vector3d& place, const Eigen::Vector3d& outward, std::vector<Neighbour>& found) const {
    for (const std::size_t count : {std::size_t{1}, kAround, kFarAround}) {
      tree_.nearest(place, count, found);
      for (const Neighbour& neighbour : found) {
        if (points_.normals[neighbour.index].dot(outward) >= 0) return neighbour;
      }
    }
    return std::nullopt;
  }

  /// The points nearest to a place, ascending. Replaces `found`.
  void around(const Eigen::Vector3d& place, std::size_t count, std::vector<Neighbour>& found) const { tree_.nearest(place, count, found); }

  /// From a point to its sixth neighbour, or to the last of a few.
  double at(std::uint32_t point, std::vector<Neighbour>& found) const {
    double known = known_[point].load(std::memory_order_relaxed);
    if (known != kUnknown) return known;
    tree_.nearest(points_.positions[point], kSixth, found);
    known = std::sqrt(found.back().squared_distance);
    known_[point].store(known, std::memory_order_relaxed);  // whoever else asks finds the same
    return known;
  }

 private:
  static constexpr std::size_t kAround = 16, kFarAround = 128;  // the other side may be scanned more densely
  static constexpr std::size_t kSixth = 7;                      // the point itself is the first
  static constexpr double kUnknown = -1.0;

  const cloud::OrientedPoints& points_;
  Nearest tree_;
  mutable std::vector<std::atomic<double>> known_;
};

}  // namespace isotouch::field
