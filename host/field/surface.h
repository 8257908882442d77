/// The surface through oriented points: local models blended into one continuous signed distance.
///
/// The distance at x is the mean of the models of the 8 nearest samples, weighted (1 - d²/R²)^4 where R reaches the ninth, so that a sample
/// enters and leaves with weight zero. Near an edge all of them know the same two pieces, so the blend keeps it sharp.
///
/// source    partition of unity with sharp features: Ohtake, Belyaev, Alexa, Turk, Seidel, Multi-level partition of unity implicits, 2003
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "host/field/blend_brick.h"
#include "host/field/bricks.h"
#include "host/field/scan.h"
#include "host/field/winding_level.h"
#include "host/field/winding_sign.h"

namespace isotouch::field {

struct Box {
  Eigen::Vector3d low, high;

  /// At most the distance to the box's surface outside, negative inside.
  double distance(const Eigen::Vector3d& x) const { return std::max((low - x).maxCoeff(), (x - high).maxCoeff()); }
};

/// All of space.
inline const Box kEverywhere{Eigen::Vector3d::Constant(-1e300), Eigen::Vector3d::Constant(1e300)};

class Surface {
 public:
  /// scan      borrowed: it stays alive and unchanged; at least 2 samples
  /// closing   the body ends where this box ends
  explicit Surface(const Scan& scan, const Box& closing = kEverywhere) : Surface(scan, local_models(scan), closing) {}
  /// models    one a sample
  /// noise     as for `WindingSign`, as is `doubt`; above 0, all samples are doubtful
  Surface(const Scan& scan, std::vector<LocalModel> models, const Box& closing, double noise = 0.0, const Doubt& doubt = kDoubt);

  /// Signed distance in the points' unit, negative inside; conservative: it does not overestimate the way to the surface beyond the blend's
  /// error.
  double distance(const Eigen::Vector3d& x) const;

  /// The body ends where this ends.
  const Box& closing() const { return closing_; }
  /// What the scan as a whole says.
  const WindingSign& enclosure() const { return enclosure_; }

  /// The same at the 4x4x4 points first + (i, j, k), in single precision: to 1e-4 for coordinates in voxels.
  BrickDistances brick(const Eigen::Vector3d& first, double reach) const;

 private:
  double blend(const Eigen::Vector3d& x, std::span<const Neighbour> nearest, bool held) const;

  /// Far from every sample, is the sign another than most planes of the nearest samples say?
  bool contradicted(bool inside, const Eigen::Vector3d& x, std::span<const Neighbour> nearest) const;
  /// Holds the distances at the places of a brick whose bits are set. Did one change its sign?
  ///
  /// level        hold them to the level of the winding number, too
  /// candidates   as for `BrickBlend`
  bool hold(const Eigen::Vector3d& first, std::uint64_t places, std::span<const Neighbour> candidates, bool level,
            std::array<float, 64>& samples) const;

  const Scan& scan_;
  Box closing_;
  bool noisy_;
  WindingSign enclosure_;
  std::vector<EmptyBalls> balls_;
  std::vector<LocalModel> models_;
  WindingLevel level_;
  BrickBlend brick_;
};

}  // namespace isotouch::field
