/// Where a ray meets a mesh.
#pragma once

#include <Eigen/Core>
#include <optional>

#include "host/field/triangle_tree.h"

namespace isotouch::field {

struct FaceHit {
  double t;                ///< along the ray
  Eigen::Vector3d normal;  ///< unit, of the face, outward
  bool from_inside;        ///< the ray meets the face's back
};

/// The first face on the ray from + t · direction, t at least `begin`.
///
/// direction  unit
/// source     the triangle by its plane and the sides in it: T. Möller and B. Trumbore, Journal of Graphics Tools 2(1), 1997
std::optional<FaceHit> first_hit(const TriangleTree& tree, const Eigen::Vector3d& from, const Eigen::Vector3d& direction, double begin = 0);

}  // namespace isotouch::field
