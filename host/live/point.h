/// A point of a live field, in integers: sums of them do not depend on their order.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <optional>

#include "host/field/band_field.h"

namespace isotouch::live {

inline constexpr int kPositionBits = 12;  ///< a position is in 1/4096 voxel
inline constexpr int kNormalBits = 14;    ///< a component of a normal is in 1/16384

struct Point {
  std::array<std::int32_t, 3> position;  ///< index coordinates, kPositionBits fraction bits, not negative
  std::array<std::int16_t, 3> normal;    ///< outward, kNormalBits fraction bits; never all zero

  bool operator==(const Point&) const = default;
};

/// position   workspace, mm
/// normal     outward, of any length
/// returns    nothing where the position is not within the grid, or where position or normal is not a finite number or the normal is zero
std::optional<Point> point_in(const field::Grid& grid, const Eigen::Vector3d& position, const Eigen::Vector3d& normal);

/// A number for each point. Their sum names a set of points, in whatever order they came.
std::uint64_t hash_of(const Point& point);

}  // namespace isotouch::live
