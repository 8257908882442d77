/// Whence a scan of one side was seen.
#pragma once

#include <Eigen/Core>

#include "host/field/scan.h"

namespace isotouch::field {

/// What a sensor sees looks at it. So the direction to the sensor is the one that the normals of hardly any sample look away from.
///
/// scan      of one side, without strays; outward normals
/// front     unit, the mean normal's direction: taken as it is where the normals leave more than one
/// returns   unit, from the scan to the sensor
Eigen::Vector3d line_of_sight(const Scan& scan, const Eigen::Vector3d& front);

}  // namespace isotouch::field
