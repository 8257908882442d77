/// The project's own objects: exact implicit functions, and oriented points drawn from them.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "host/cloud/oriented_points.h"

namespace isotouch::cloud {

/// An object whose surface is known. Lengths are in the shape's own units.
struct Shape {
  std::string name;
  std::size_t default_points = 3756;
  bool exact_distance = false;                                  ///< is `distance` the Euclidean one, or only zero on the surface and of the right sign
  std::function<double(const Eigen::Vector3d&)> distance;       ///< negative inside
  std::function<Eigen::Vector3d(const Eigen::Vector3d&)> normal;///< outward unit normal of the surface piece nearest to a point near the surface
  Eigen::Vector3d low, high;                                    ///< a box that contains the surface
};

/// The names that `shape` accepts: sphere torus box plate capsules, then hydrant owl boy bomberman jaguar.
const std::vector<std::string>& shape_names();

/// fails     InputError that lists the names
Shape shape(std::string_view name);

/// Evenly spread points on the surface with exact normals (Poisson-disk by sample elimination), the same for the same seed on every machine.
OrientedPoints sample_shape(const Shape& shape, std::size_t count, std::uint64_t seed = 1);

/// Area-uniform points on the surface with exact normals: fresh ones for evaluation.
OrientedPoints scatter_on_shape(const Shape& shape, std::size_t count, std::uint64_t seed);

}  // namespace isotouch::cloud
