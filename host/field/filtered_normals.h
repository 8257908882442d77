/// Normals with noise, each taken from the plane or the curved patch that explains its surroundings best.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "host/field/scan.h"

namespace isotouch::field {

/// Every sample and its six nearest describe a plane: it passes near their positions, and its normal is near theirs. Where a curved patch through the
/// nearest twelve explains them better for its number of parameters, as round a thin rod, the patch is taken instead. A sample's new normal is the mean
/// of the planes and patches of its nearest nine, there where the sample is, weighted by how well each explains its own samples, and this sample's position and normal. At an edge, the planes of its
/// own face do so, so edges stay.
///
/// scan      most normals outward
/// noise     deviation of the normals, radians, as `Roughness::of_normals`; above 0
/// returns   one unit normal a sample
/// fails     never
/// source    the least squares of planes with normals as observations; the choice among shifted neighbourhoods: Nagao and Matsuyama, Edge preserving
///           smoothing, 1979
std::vector<Eigen::Vector3d> filtered_normals(const Scan& scan, double noise);

}  // namespace isotouch::field
