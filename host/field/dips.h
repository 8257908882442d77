/// Places where a field comes so near to zero that it may be felt, although nothing is there.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "host/field/band_field.h"
#include "host/field/brick_mask.h"
#include "host/field/brick_neighbours.h"

namespace isotouch::field {

/// So many points of a scan make a piece of surface more than an accident.
inline constexpr std::uint32_t kFewestVoices = 4;

/// Samples within half a voxel of a surface that passes between them unseen: none of them hangs together with one whose neighbour is on the other
/// side, and they lie beside fewer than `kFewestVoices` of the points. A spline through them may cross zero.
///
/// bricks    sorted by cell
/// points    of the scan, index coordinates
/// returns   a set of samples for each brick
std::vector<BrickMask> unsupported_dips(const std::vector<Brick>& bricks, const Following& next,
                                        const std::vector<Eigen::Vector3d>& points);

}  // namespace isotouch::field
