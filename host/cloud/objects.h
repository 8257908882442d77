/// Five characters, after those that the published method was shown on: composed of exact primitives, one paragraph each.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <string>
#include <vector>

#include "host/cloud/bodies.h"

namespace isotouch::cloud {

struct Object {
  std::string name;
  std::string sentence;  ///< how it is made, for people
  std::size_t points;    ///< as many as the published figures were made with
  Body body;
  Eigen::Vector3d low, high;  ///< a box that contains the surface
};

/// Hydrant, owl, boy, bomberman, jaguar: x to their left, y up, z where they look (the jaguar: x is ahead). Each is one closed piece with thin
/// parts and creases. Lengths are in voxels of the published grids: owl 186 x 173 x 87, boy 126 x 187 x 72; the volumes are near the published
/// counts of inside nodes.
std::vector<Object> characters();

}  // namespace isotouch::cloud
