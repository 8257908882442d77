/// The points of one cell of two voxels a side whose normals look the same way, as sums: one sample of a live field.
///
/// Integers add and subtract exactly, so the order in which points come and go leaves no trace.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>

#include "host/live/point.h"

namespace isotouch::live {

/// Which bucket a point belongs to: the cell that it lies in, and the axis and sign of its normal's largest component. Sorts by z, y, x, side.
std::uint64_t bucket_key(const Point& point);
/// Where the bucket of a key is, in widths of a bucket.
Eigen::Vector3i bucket_place(std::uint64_t key);
/// The bucket so many widths further whose normals look the same way.
///
/// steps     -1 to 1; no point lies in the grid's outermost buckets, so there is one
std::uint64_t bucket_beside(std::uint64_t key, const Eigen::Vector3i& steps);

/// Mean position and normal of a bucket. They are rounded, so that one more point among many mostly changes nothing.
struct Mean {
  Eigen::Vector3d position = Eigen::Vector3d::Zero();  ///< index coordinates, within the bucket's cell
  Eigen::Vector3d normal = Eigen::Vector3d::Zero();    ///< unit, outward

  bool operator==(const Mean& o) const { return position == o.position && normal == o.normal; }
};

class Bucket {
 public:
  void add(const Point& point);
  /// fails     never; but only what was added may be removed
  void remove(const Point& point);
  std::uint32_t count() const { return count_; }
  /// Of at least one point.
  Mean mean() const;

 private:
  std::uint32_t count_ = 0;
  std::array<std::int64_t, 3> position_{}, normal_{};
};

}  // namespace isotouch::live
