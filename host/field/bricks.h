/// The bricks of a band, found by walking along the surface: cost grows with its area, never with the volume.
#pragma once

#include <Eigen/Core>
#include <array>
#include <functional>
#include <vector>

#include "host/field/band_field.h"

namespace isotouch::field {

/// The 64 signed distances (voxels, x fastest) of the brick with these brick coordinates.
using BrickDistances = std::function<std::array<double, 64>(const Eigen::Vector3i& cell)>;
/// The signed distance at a point in index coordinates.
using PointDistance = std::function<double(const Eigen::Vector3d& index)>;

/// seeds     brick coordinates from which the walk starts, any order, repeats allowed; outside [0, cells) they are ignored
/// cells     bricks along each axis
/// band      half width, voxels
/// at        used to pass over bricks far from the surface by one look at their centre: its slope must not exceed one by much
/// returns   every brick with a sample within the band that neighbours, face to face, lead to from a seed; also those across whose face the
/// sign
///           changes. Sorted by z, then y, then x.
std::vector<Brick> band_bricks(const std::vector<Eigen::Vector3i>& seeds, const Eigen::Vector3i& cells, double band,
                               const BrickDistances& distances, const PointDistance& at);

}  // namespace isotouch::field
