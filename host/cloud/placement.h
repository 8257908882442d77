/// Where a cloud lies in the workspace: its box centred on the origin, its size true or made to fit.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <span>
#include <string_view>

#include "host/cloud/oriented_points.h"

namespace isotouch::cloud {

/// A Falcon's handle reaches a ball of about this radius round the middle of the workspace, mm.
inline constexpr double kFalconReach = 50;

struct PlacementOptions {
  std::optional<double> mm_per_unit;  ///< the cloud's units are known: keep the true size
  double fit_mm = 70.0;               ///< otherwise: the longest side of the box; well within `kFalconReach`
};

/// fails     InputError unless `units` is mm, cm, m or in
double mm_per_unit(std::string_view units);

/// positions at least two different ones
/// fails     InputError when a size asked for is not positive, or the placed cloud would be smaller than 1 mm or larger than 1000 mm
Placement place(std::span<const Eigen::Vector3d> positions, const PlacementOptions& options = {});

/// The points in the workspace, mm. A scale is never negative, so normals stay.
OrientedPoints placed(const OrientedPoints& points, const Placement& placement);

}  // namespace isotouch::cloud
