/// How fine a grid is where nobody says so, and which grid is finer than the points of a scan support.
///
/// Chosen by what hands feel (`isotouch compare --felt`): on a mesh the errors fall with the voxel. On a scan they fall only until there are about two voxels
/// between neighbouring points; DECISIONS.md, entry 123.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cmath>

namespace isotouch::field {

/// Voxels along the longest side: the grid of the paper's objects, and of scans that show no more.
inline constexpr int kCoarseGrid = 186;
/// Of meshes and dense scans.
inline constexpr int kFineGrid = 372;
/// Voxels between neighbouring points up to which a finer grid shows more, and from which on it only takes more memory.
inline constexpr double kUsefulVoxels = 2, kUselessVoxels = 6;
/// Bytes of a field for each square voxel of its surface: a cube takes 20.9 at 3 voxels of band.
inline constexpr double kBytesPerSquareVoxel = 21;
/// Bytes that a default grid aims at: three quarters of what a controller keeps by default.
inline constexpr double kDefaultBytes = 12 << 20;

/// The usual grid, kCoarseGrid to kFineGrid: as fine as the points support, and so coarse that a surface as large as its box fits a controller.
///
/// sides     of the box round the object, in the unit of the points; the longest is above 0
/// spacing   median distance of neighbouring points, in the same unit; 0 for a mesh, which is known everywhere
/// returns   voxels along the longest side
/// fails     never
inline int default_grid(const Eigen::Vector3d& sides, double spacing) {
  const double longest = sides.maxCoeff();
  const Eigen::Vector3d of = sides / longest;
  const double area = 2 * (of.x() * of.y() + of.y() * of.z() + of.z() * of.x());
  const double fitting = std::sqrt(kDefaultBytes / (kBytesPerSquareVoxel * std::max(area, 1e-9)));
  const double useful = kUsefulVoxels * longest / std::max(spacing, 1e-9 * longest);
  return std::max(kCoarseGrid, static_cast<int>(std::min({useful, fitting, double{kFineGrid}})));
}

/// The finest grid that still shows more of such points.
///
/// longest   side of the box round the object, above 0
/// spacing   median distance of neighbouring points, in the same unit, above 0
/// returns   voxels along the longest side
inline int finest_grid(double longest, double spacing) { return static_cast<int>(std::min(kUselessVoxels * longest / spacing, 1e6)); }

}  // namespace isotouch::field
