/// How much of a field's surface lies where no point was.
#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

#include "host/field/band_field.h"

namespace isotouch::field {

/// Shares of the surface that are farther from the nearest point than so many times the distance from there to its sixth neighbour, plus a voxel. One
/// of sixteen samples beside the surface is asked.
///
/// points    workspace, mm; at least one
/// limits    how many times
std::array<double, 2> unseen_shares(const BandField& field, const std::vector<Eigen::Vector3d>& points,
                                    const std::array<double, 2>& limits);

}  // namespace isotouch::field
