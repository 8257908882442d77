#include "host/live/bucket.h"

#include <cmath>
#include <cstdlib>

namespace isotouch::live {

namespace {
constexpr double kPositionSteps = 64;         // of a mean, a voxel
constexpr double kNormalSteps = 512;          // of a mean normal's component
constexpr int kAxisBits = 13, kSideBits = 3;  // of a key
constexpr int kVoxelBits = 1;                 // a bucket is so many doublings of a voxel wide
}  // namespace

std::uint64_t bucket_key(const Point& point) {
  std::uint64_t key = 0;
  for (std::size_t axis = 3; axis-- > 0;)
    key = key << kAxisBits | static_cast<std::uint64_t>(point.position[axis] >> (kPositionBits + kVoxelBits));
  std::size_t side = 0;
  for (std::size_t axis = 1; axis < 3; ++axis) {
    if (std::abs(int{point.normal[axis]}) > std::abs(int{point.normal[side]})) side = axis;
  }
  return key << kSideBits | side << 1 | (point.normal[side] < 0 ? 1U : 0U);
}

Eigen::Vector3i bucket_place(std::uint64_t key) {
  const auto axis = [key](int n) { return static_cast<int>(key >> (kSideBits + n * kAxisBits) & ((1U << kAxisBits) - 1)); };
  return {axis(0), axis(1), axis(2)};
}

std::uint64_t bucket_beside(std::uint64_t key, const Eigen::Vector3i& steps) {
  for (int axis = 0; axis < 3; ++axis) key += static_cast<std::uint64_t>(steps[axis]) << (kSideBits + axis * kAxisBits);
  return key;
}

void Bucket::add(const Point& point) {
  ++count_;
  for (std::size_t axis = 0; axis < 3; ++axis) position_[axis] += point.position[axis], normal_[axis] += point.normal[axis];
}

void Bucket::remove(const Point& point) {
  --count_;
  for (std::size_t axis = 0; axis < 3; ++axis) position_[axis] -= point.position[axis], normal_[axis] -= point.normal[axis];
}

Mean Bucket::mean() const {
  Mean mean;
  for (Eigen::Index axis = 0; axis < 3; ++axis) {
    const auto a = static_cast<std::size_t>(axis);
    const double position = static_cast<double>(position_[a]) / (static_cast<double>(count_) * (1 << kPositionBits));
    mean.position[axis] = (std::floor(position * kPositionSteps) + 0.5) / kPositionSteps;  // the middle of a step: it stays in its cell
    mean.normal[axis] = static_cast<double>(normal_[a]);
  }
  mean.normal /= mean.normal.norm();
  mean.normal = mean.normal.unaryExpr([](double x) { return std::floor(x * kNormalSteps + 0.5); });
  mean.normal /= mean.normal.norm();
  return mean;
}

}  // namespace isotouch::live
