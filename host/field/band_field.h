/// A signed distance, sampled on a regular grid in a band on both sides of the surface: what every method makes and the field is written from.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <tuple>
#include <vector>

namespace isotouch::field {

/// Sample (i, j, k) lies at origin + edge * (i, j, k).
struct Grid {
  Eigen::Vector3d origin = Eigen::Vector3d::Zero();  ///< workspace, mm
  double edge = 1.0;                                 ///< mm a voxel
  Eigen::Vector3i size = Eigen::Vector3i::Zero();    ///< samples along each axis

  Eigen::Vector3d position(const Eigen::Vector3i& sample) const { return origin + edge * sample.cast<double>(); }
  Eigen::Vector3d to_index(const Eigen::Vector3d& point) const { return (point - origin) / edge; }
};

/// Cells of bricks are sorted by this: z, then y, then x.
inline auto sort_key(const Eigen::Vector3i& cell) { return std::tuple(cell.z(), cell.y(), cell.x()); }

/// 4x4x4 samples, stored together (image_layout::kBrickShift).
struct Brick {
  Eigen::Vector3i cell;            ///< brick coordinates: its first sample is 4 * cell
  std::array<float, 64> distance;  ///< voxels, negative inside, x fastest; beyond +-band the value only needs the right sign
};

/// Half width of the band unless another is asked for, voxels; the usual one of narrow-band level sets, too. The proxy stays at the surface, and
/// on its way there it may go as far as the band is wide in each step.
inline constexpr double kBand = 3.0;

/// Every brick that holds a sample with |distance| <= band is listed; the others are wholly outside or wholly inside the object.
struct BandField {
  Grid grid;
  double band = kBand;                 ///< half width, voxels
  std::vector<Brick> bricks;           ///< sorted by cell: z, then y, then x
  std::vector<double> stiffness = {};  ///< of the surface near each brick, N/mm; none where it is the same everywhere
};

}  // namespace isotouch::field
