/// Where a mesh runs through itself, and whether it touches itself.
#pragma once

#include <Eigen/Core>
#include <cstddef>

#include "host/field/face_tree.h"

namespace isotouch::field {

struct FaceCrossings {
  std::size_t faces = 0;                            ///< that run through another one of a higher number
  Eigen::Vector3d first = Eigen::Vector3d::Zero();  ///< the middle of the first of them
  bool touching = false;                            ///< two faces touch that do not cross
};

/// Two faces cross when an edge of one runs through the inside of the other; of faces with a common corner only the edges opposite that corner are
/// asked, and faces with a common edge do not cross. Faces that only touch do not cross; the test is in doubles, so faces closer than rounding may
/// count as either. Faces without a common corner touch when they are within `touching`, so that faces rounded to floats touch, too.
///
/// mesh      the one that the tree was grown on
/// touching  of the mesh's size
FaceCrossings face_crossings(const cloud::TriangleMesh& mesh, const FaceTree& tree, double touching = 1e-6);

}  // namespace isotouch::field
