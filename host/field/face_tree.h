/// A tree of boxes round a mesh's faces: what every question about the mesh walks down.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <vector>

#include "host/cloud/mesh.h"

namespace isotouch::field {

struct FaceTree {
  struct Node {
    Eigen::Vector3d low, high;
    std::uint32_t first = 0;  ///< of `faces`
    std::uint32_t count = 0;  ///< of them, all below this node
    std::uint32_t right = 0;  ///< children are the next node and this one; 0 in a leaf
  };
  struct Face {
    std::array<Eigen::Vector3d, 3> corners;
    std::uint32_t number = 0;  ///< in the mesh
  };

  /// Halves the faces by their middles along the longest side until at most four are left; ties by number.
  ///
  /// mesh      at least one face
  explicit FaceTree(const cloud::TriangleMesh& mesh);

  std::vector<Node> nodes;  ///< the root first; 32 levels hold every mesh
  std::vector<Face> faces;  ///< leaf by leaf
};

}  // namespace isotouch::field
