/// Bits of surface that are too small for the grid.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "host/encoding/apron.h"
#include "host/encoding/spline.h"

namespace isotouch::encoding {

/// Coefficients of one sign that hang together face to face, and are so few, are no part of a body but roughness: two voxels a side. A ball of up to three
/// voxels across may have no more.
inline constexpr int kSmallComponent = 8;

struct SmallComponents {
  std::size_t pieces = 0;    ///< that were inside
  std::size_t cavities = 0;  ///< that were outside
  std::vector<std::string> warnings() const;
};

/// Turns the sign of every such set that coefficients of the other sign enclose, unless it touches the tip of something larger at an edge or a corner. A
/// spline whose coefficients have one sign has no zero among them, so no
/// tiny piece or hole stands beside the surface of a noisy scan.
///
/// around    `neighbours` of the field that the coefficients are of
/// returns   how many sets
/// fails     never
SmallComponents drop_small_components(std::vector<Coefficients>& coefficients, const std::vector<Neighbours>& around);

}  // namespace isotouch::encoding
