/// How often a mesh goes round a point.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "host/field/face_tree.h"

namespace isotouch::field {

/// The sum of the solid angles of all faces over 4 pi: on a closed mesh the number of times that its faces, turned outward, enclose the point.
/// A branch that is more than twice its radius away counts as one dipole.
///
/// source    A. Jacobson, L. Kavan, O. Sorkine-Hornung, Robust inside-outside segmentation using generalized winding numbers, 2013;
///           the tree: G. Barill et al., Fast winding numbers for soups and clouds, 2018; solid angle: Van Oosterom and Strackee, 1983
class WindingNumber {
 public:
  /// tree      stays alive and unchanged
  explicit WindingNumber(const FaceTree& tree);

  /// Within 0.1 of the whole number on a closed mesh; half way between two of them on a face.
  double operator()(const Eigen::Vector3d& point) const;

 private:
  struct Dipole {
    Eigen::Vector3d area;    ///< sum of the faces' areas along their normals
    Eigen::Vector3d centre;  ///< mean of their middles, weighted by area
    double far = 0;          ///< squared distance from which on the branch is a dipole
  };

  const FaceTree& tree_;
  std::vector<Dipole> dipoles_;  ///< one a node
};

}  // namespace isotouch::field
