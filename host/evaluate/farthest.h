/// The place of one surface that lies farthest from another.
#pragma once

#include <Eigen/Core>

#include "host/field/triangle_tree.h"

namespace isotouch::evaluate {

struct Farthest {
  Eigen::Vector3d place = Eigen::Vector3d::Zero();
  double distance = 0;  ///< of this place, exact
};

/// Measures from corners and middles of triangles that are halved as far as needed: a part whose middle is so near that no point of it can be
/// farther than what was found is left out, so that whole boxes of triangles cost one question.
///
/// fineness   > 0
/// returns    a place of `surface` and its distance from `other`. No place of `surface` is farther by more than `fineness`, no corner of a triangle
///            by more than an eighth of it
/// source     branch and bound for the Hausdorff distance: M. Guthe, P. Borodin, R. Klein, "Fast and accurate Hausdorff distance calculation
///            between meshes", Journal of WSCG 13(2), 2005
Farthest farthest(const field::TriangleTree& surface, const field::TriangleTree& other, double fineness);

}  // namespace isotouch::evaluate
