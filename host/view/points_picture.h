/// Oriented points as small lit discs that face along their normals.
#pragma once

#include <Eigen/Core>
#include <array>
#include <string>
#include <vector>

#include "host/cloud/oriented_points.h"
#include "host/view/camera.h"
#include "host/view/picture.h"

namespace isotouch::view {

struct PointsOptions {
  int width = 960, height = 720;
  Direction direction = {};
  std::string title = {};
  double spacing = 1;                                    ///< from a point to its nearest neighbour, the points' units: the discs' diameter
  double mm_per_unit = 1;                                ///< 0: the unit is not known; no scale bar then
  double rim_length = 0;                                 ///< of all open rims together, the points' units
  std::vector<std::array<Eigen::Vector3d, 2>> rim = {};  ///< where the scan ends: drawn as lines, pale where points hide them
};

/// Discs that are seen from behind are pale: they lie on the far side of the object, or their normals are the wrong way round.
///
/// points    at least one
Picture points_picture(const cloud::OrientedPoints& points, const PointsOptions& options);

}  // namespace isotouch::view
