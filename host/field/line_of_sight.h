/// Whence a scan of one side was seen.
#pragma once

#include <Eigen/Core>
#include <optional>

#include "host/field/scan.h"

namespace isotouch::field {

/// What a sensor sees looks at it; it is taken to be far away. So the direction to the sensor is the one that the normals of hardly any sample look away from.
///
/// scan      of one side, without strays; outward normals
/// front     unit, the mean normal's direction: taken as it is where the normals leave more than one
/// sensor    its place, where it is known: then no normal is asked
/// returns   unit, from the scan to the sensor
Eigen::Vector3d line_of_sight(const Scan& scan, const Eigen::Vector3d& front, const std::optional<Eigen::Vector3d>& sensor = {});

}  // namespace isotouch::field
