/// A paraboloid through a sample's neighbours, from their positions alone.
#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "host/field/nearest.h"

namespace isotouch::field {

struct QuadricFit {
  Eigen::Vector3d normal;  ///< unit, at the foot of the first position, of any sign
  double height;           ///< of the paraboloid over the first position, along the normal
  double deviation;        ///< standard deviation of the positions from it, freedom counted; 0 for fewer than 8 positions
};

/// positions     of a scan
/// neighbours    of one of them, itself first; at least 3, not all at one place
/// source        moving least squares: Levin, Mesh-independent surface interpolation, 2004; one step
QuadricFit fit_quadric(const std::vector<Eigen::Vector3d>& positions, std::span<const Neighbour> neighbours);

}  // namespace isotouch::field
