/// Where a live field lies: it is decided once, before the first point.
#pragma once

#include <Eigen/Geometry>
#include <optional>

#include "host/cloud/placement.h"
#include "host/field/band_field.h"

namespace isotouch::live {

struct SpaceOptions {
  cloud::PlacementOptions size = {};  ///< of the box
  bool stays = false;                 ///< the input is in workspace mm: it is neither scaled nor moved
  std::optional<double> voxel_mm = {};
  std::optional<int> grid = {};  ///< voxels along the longest side of the box, without `voxel_mm`
  double band = field::kBand;    ///< voxels
};

struct Space {
  Eigen::AlignedBox3d box;  ///< input coordinates; points outside it are left out
  cloud::Placement placement;
  field::Grid grid;
};

/// fails     InputError: the box has no extent, or its size does not fit a field
Space space_for(const Eigen::AlignedBox3d& box, const SpaceOptions& options);

}  // namespace isotouch::live
