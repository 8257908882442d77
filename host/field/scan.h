/// The samples of a scan and who is near whom: what every step of the field works on.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "host/cloud/oriented_points.h"
#include "host/field/nearest.h"

namespace isotouch::field {

class Scan {
 public:
  /// Samples in a sample's list, itself among them.
  static constexpr std::size_t kListed = 17;

  /// points    any length unit; unit outward normals; at least 1
  explicit Scan(cloud::OrientedPoints points);

  const std::vector<Eigen::Vector3d>& positions() const { return points_.positions; }
  const std::vector<Eigen::Vector3d>& normals() const { return points_.normals; }
  const std::vector<double>& stiffness() const { return points_.stiffness; }
  std::size_t size() const { return points_.size(); }
  const Nearest& tree() const { return tree_; }
  /// Some of the samples, which lie together: for loops over all of them. In the order of a large scan each neighbour would be a cache miss.
  ///
  /// begin, end   within [0, size()]
  std::span<const std::uint32_t> together(std::size_t begin, std::size_t end) const {
    return std::span(tree_.order()).subspan(begin, end - begin);
  }
  /// The nearest samples of a sample, ascending, all of a small set.
  std::span<const Neighbour> around(std::size_t sample) const { return std::span(lists_).subspan(sample * listed_, listed_); }
  /// The first `most` of these, or all where there are fewer.
  std::span<const Neighbour> around(std::size_t sample, std::size_t most) const { return around(sample).first(std::min(most, listed_)); }

  /// The distance to a sample's sixth neighbour, or to the last of a small set: how far apart samples are there.
  double spacing(std::size_t sample) const { return std::sqrt(around(sample)[std::min<std::size_t>(6, listed_ - 1)].squared_distance); }

  /// The median of that.
  double median_spacing() const;

  void turn_normal(std::size_t sample) { points_.normals[sample] = -points_.normals[sample]; }

 private:
  cloud::OrientedPoints points_;
  Nearest tree_;
  std::size_t listed_;
  std::vector<Neighbour> lists_;
};

}  // namespace isotouch::field
