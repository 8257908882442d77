/// The project's own objects: exact implicit functions, and oriented points drawn from them.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "host/cloud/oriented_points.h"

namespace isotouch::cloud {

/// An object whose surface is known. Lengths are in the shape's own units, which are those of a voxel on a grid of the paper's size.
///
/// `distance` has the right sign everywhere, is zero exactly on the surface and never exceeds the Euclidean distance in magnitude. It *is* the
/// Euclidean distance for sphere, torus, box and plate; for the capsules outside and, inside, wherever the nearest surface point of the nearer
/// capsule does not lie in the other one. `normal` is exact on every smooth piece; on a crease it is that of one of the pieces that meet there.
struct Shape {
  std::string name;
  std::string sentence;  ///< how it is made, for people
  std::size_t default_points = 3756;
  bool exact_distance = false;                             ///< true for the five shapes of the sentence above
  std::function<double(const Eigen::Vector3d&)> distance;  ///< negative inside
  std::function<Eigen::Vector3d(const Eigen::Vector3d&)>
      normal;                    ///< outward unit normal of the surface piece nearest to a point near the surface
  Eigen::Vector3d low, high;     ///< a box that contains the surface
  std::optional<double> volume;  ///< what it encloses, where that is known
};

/// The names that `shape` accepts: sphere torus box plate capsules, then hydrant owl boy bomberman jaguar.
const std::vector<std::string>& shape_names();

/// fails     InputError that lists the names
Shape shape(std::string_view name);

/// Evenly spread points on the surface with exact normals: a Poisson-disk set by sample elimination from eight times as many area-uniform
/// candidates, the same for a seed on every machine. Their order is random.
OrientedPoints sample_shape(const Shape& shape, std::size_t count, std::uint64_t seed = 1);

/// Area-uniform points on the surface with exact normals: fresh ones for evaluation. No spacing is kept; those of one line through the body
/// (two, mostly) are drawn together.
OrientedPoints scatter_on_shape(const Shape& shape, std::size_t count, std::uint64_t seed);

}  // namespace isotouch::cloud
