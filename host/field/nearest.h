/// The samples nearest to a point, by kd-tree.
///
/// Answers are totally ordered by (squared distance, index), so equal distances give the same answer on every machine.
///
/// source    J. H. Friedman, J. L. Bentley, R. A. Finkel, An algorithm for finding best matches in logarithmic expected time, 1977
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

namespace isotouch::field {

struct Neighbour {
  double squared_distance;
  std::uint32_t index;

  bool operator<(const Neighbour& o) const {
    return squared_distance < o.squared_distance || (squared_distance == o.squared_distance && index < o.index);
  }
};

/// Summed as the tree sums it, so that both round alike.
inline double squared_distance(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
  const Eigen::Vector3d d = a - b;
  return (d.x() * d.x() + d.y() * d.y()) + d.z() * d.z();
}

class Nearest {
 public:
  /// positions   at least one
  explicit Nearest(const std::vector<Eigen::Vector3d>& positions);
  ~Nearest();
  Nearest(const Nearest&) = delete;
  Nearest& operator=(const Nearest&) = delete;

  /// All samples, those that lie together one after the other.
  const std::vector<std::uint32_t>& order() const;
  /// The `count` nearest samples in ascending order; fewer when the set is smaller. Replaces `found`.
  void nearest(const Eigen::Vector3d& point, std::size_t count, std::vector<Neighbour>& found) const;
  /// The `count` nearest samples and all others that are at most `margin` farther away than the last of these, ascending. Replaces `found`.
  ///
  /// count     1 to kMaxWithBeyond
  static constexpr std::size_t kMaxWithBeyond = 16;
  void nearest_and_beyond(const Eigen::Vector3d& point, std::size_t count, double margin, std::vector<Neighbour>& found) const;
  /// Every sample within `radius`, ascending. Replaces `found`.
  void within(const Eigen::Vector3d& point, double radius, std::vector<Neighbour>& found) const;
  /// The same, in an order of the tree's own: for sums and counts this must not matter.
  void within_in_any_order(const Eigen::Vector3d& point, double radius, std::vector<Neighbour>& found) const;

 private:
  class Tree;
  std::unique_ptr<Tree> tree_;
  std::size_t size_;
};

}  // namespace isotouch::field
