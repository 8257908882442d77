/// How large a voxel is for a scan: as asked for, or the usual one.
///
/// real time   no
#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>

#include "host/field/sound_scan.h"

namespace isotouch::field {

/// What the caller asks for. If both are given, voxel_mm decides.
struct GridWish {
  std::optional<double> voxel_mm = {};  ///< edge of a voxel, mm of the workspace, above 0
  std::optional<int> grid = {};         ///< voxels along the longest side, 1 or more
};

struct ScanVoxel {
  double edge_mm;       ///< mm of the workspace
  std::string warning;  ///< one sentence if the grid that was asked for is finer than the scan supports; else empty
};

/// sound     the scan in its own unit, before it is placed in the workspace
/// sides     sides of the box around its measured points, in the scan's unit; the longest is above 0
/// scale     mm of the workspace for one unit of the scan, above 0
/// usual     voxels along the longest side if nothing is asked for
/// fails     never
ScanVoxel scan_voxel(const SoundScan& sound, const Eigen::Vector3d& sides, double scale, const GridWish& wish, int usual);

}  // namespace isotouch::field
