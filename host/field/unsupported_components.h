/// Pieces of a field that no sample stands for: shards where models meet far from the samples, and bubbles in the body.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <functional>
#include <vector>

#include "host/field/band_field.h"

namespace isotouch::field {

struct UnsupportedComponents {
  std::size_t pieces = 0;    ///< of the body, made outside
  std::size_t cavities = 0;  ///< in the body, filled
};

/// Turns the sign of every connected set of samples, face to face, that is no part of the far inside or far outside and lies beside fewer than four of
/// the scan's points; or beside fewer than sixty-four, where the scan as a whole contradicts most of the set.
///
/// field      bricks sorted by cell; of unlisted bricks each has the sign of the samples that face it
/// points     of the scan, index coordinates
/// enclosed   of a place, index coordinates: does the scan as a whole hold it for inside?
/// returns    what was dropped; of what it enclosed, each piece gets the sign of what lies round it. Places where the field almost touches zero and no
///            points lie are filled as well, and are not counted. The distances beside it are those to what is left.
/// source     connected components by union and find: Tarjan, Efficiency of a good but not linear set union algorithm, 1975
UnsupportedComponents drop_unsupported(BandField& field, const std::vector<Eigen::Vector3d>& points,
                                       const std::function<bool(const Eigen::Vector3d&)>& enclosed);

}  // namespace isotouch::field
