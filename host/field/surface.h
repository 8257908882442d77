/// The surface through oriented points: local models blended into one continuous signed distance.
///
/// The distance at x is the mean of the models of the 8 nearest samples, weighted (1 - d²/R²)^4 where R reaches the ninth, so that a sample
/// enters and leaves with weight zero. Near an edge all of them know the same two pieces, so the blend keeps it sharp.
///
/// source    partition of unity with sharp features: Ohtake, Belyaev, Alexa, Turk, Seidel, Multi-level partition of unity implicits, 2003
#pragma once

#include <array>
#include <span>
#include <vector>

#include "host/field/blend_brick.h"
#include "host/field/scan.h"

namespace isotouch::field {

class Surface {
 public:
  /// scan      borrowed: it stays alive and unchanged; at least 2 samples
  explicit Surface(const Scan& scan);

  /// Signed distance in the points' unit, negative inside; conservative: it does not overestimate the way to the surface beyond the blend's
  /// error.
  double distance(const Eigen::Vector3d& x) const;

  /// The same at the 4x4x4 points first + (i, j, k), x fastest, in one search and in single precision: to 1e-4 for coordinates in voxels.
  std::array<float, 64> distances(const Eigen::Vector3d& first) const;

 private:
  double blend(const Eigen::Vector3d& x, std::span<const Neighbour> nearest) const;

  const Scan& scan_;
  std::vector<EmptyBalls> balls_;
  std::vector<LocalModel> models_;
  BrickBlend brick_;
};

}  // namespace isotouch::field
