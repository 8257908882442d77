/// How a recorded hand moves, in the frame of a surface that it is led over.
#pragma once

#include <Eigen/Core>
#include <vector>

namespace isotouch::evaluate {

struct PlaneMotion {
  std::vector<double> ahead, aside;  ///< mm, from tick to tick; at most 1 mm either way
  std::vector<double> depth;         ///< mm below the surface, 0.1 to 1
};

/// The two directions in which the hand moves most span its main plane. What it moves along this plane becomes motion along the surface. What it
/// moves across the plane, against the mean of the 250 ticks on either side, becomes depth.
///
/// positions    mm, one a tick, at least one
PlaneMotion plane_motion(const std::vector<Eigen::Vector3d>& positions);

}  // namespace isotouch::evaluate
