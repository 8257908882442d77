/// A back for a scan of one side: what nobody saw, invented so that the sheet bounds a body.
#pragma once

#include <Eigen/Core>

#include "host/cloud/oriented_points.h"
#include "host/field/scan.h"

namespace isotouch::field {

/// Depth of the body behind the deepest sample, as a share of the scan's longest side.
inline constexpr double kBackDepth = 0.1;

/// Oriented points for walls and back: below every rim of the sheet, seen from its front, a wall goes straight back, and a plane closes the body
/// there. Where the rim's normals look sideways, the wall goes on as they say; gaps of a few spacings are filled; a hole stays open where its rim
/// looks into it, as the hole of a ring does, and is filled where its rim looks to the front, as a gap in a scan does.
///
/// scan      of one side, without strays
/// front     unit, to the sensor
cloud::OrientedPoints sheet_back(const Scan& scan, const Eigen::Vector3d& front);

}  // namespace isotouch::field
