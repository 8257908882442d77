/// Where a ray meets a mesh.
#pragma once

#include <optional>

#include "host/field/triangle_tree.h"
#include "host/view/camera.h"

namespace isotouch::view {

struct MeshHit {
  double t;                ///< mm along the ray
  Eigen::Vector3d normal;  ///< unit, of the face, outward
  bool from_inside;        ///< the ray meets the face's back
};

/// The first face along a ray from `from` (mm) on.
std::optional<MeshHit> first_hit(const field::TriangleTree& tree, const Ray& ray, double from = 0);

}  // namespace isotouch::view
