/// Normals with noise, each taken from the plane or the curved patch that explains its surroundings best.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "host/field/scan.h"

namespace isotouch::field {

/// Every sample and its six nearest describe a plane: it passes near their positions, and its normal is near theirs. Round a thin rod a curved patch
/// through the nearest twelve explains them better, for its number of parameters; then it is taken. A sample's new normal is the mean of the normals
/// that the patches of its nearest nine have where the sample is. Each is weighted by how well it explains its own samples, and this sample's position
/// and normal. At an edge the patches of its own face do so best, so an edge is rounded little.
///
/// scan      most normals outward
/// noise     deviation of the normals, radians, as `Roughness::of_normals`; above 0
/// returns   one unit normal a sample
/// fails     never
/// source    the least squares of planes with normals as observations; the choice among shifted neighbourhoods: Nagao and Matsuyama, Edge preserving
///           smoothing, 1979
std::vector<Eigen::Vector3d> filtered_normals(const Scan& scan, double noise);

}  // namespace isotouch::field
