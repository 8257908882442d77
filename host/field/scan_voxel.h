/// How large a voxel is for a scan: as asked for, or as fine as the scan supports.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>

#include "host/field/sound_scan.h"

namespace isotouch::field {

/// What somebody asks for; the voxel counts before the grid.
struct GridWish {
  std::optional<double> voxel_mm = {};
  std::optional<int> grid = {};      ///< voxels along the longest side
  const char* grid_name = "--grid";  ///< what the caller calls it, for the warning
};

struct ScanVoxel {
  double edge_mm;
  std::string warning;  ///< one sentence: the grid that was asked for is finer than the scan supports; else empty
};

/// sound     not placed yet
/// sides     of the box round its measured points, their unit; the longest above 0
/// scale     from their unit to mm of the workspace
/// usual     the grid where nothing is asked for
ScanVoxel scan_voxel(const SoundScan& sound, const Eigen::Vector3d& sides, double scale, const GridWish& wish, int usual);

}  // namespace isotouch::field
