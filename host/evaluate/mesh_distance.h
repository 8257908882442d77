/// The exact signed distance to a closed triangle mesh.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <vector>

#include "host/cloud/mesh.h"

namespace isotouch::evaluate {

/// The nearest place of the mesh is found through a tree of boxes; the sign is the side of the pseudonormal there: of the face, the sum of both
/// faces' at an edge, the sum weighted by the angles at a corner. This is right for every closed mesh that does not run through itself.
///
/// source    Bærentzen and Aanæs, "Signed distance computation using the angle weighted pseudonormal", IEEE TVCG 11(3), 2005;
///           nearest point of a triangle: Ericson, Real-Time Collision Detection, 2005, section 5.1.5
class MeshDistance {
 public:
  /// mesh      closed, at least one face, no face without area (it counts as its longest edge's length, with no direction of its own)
  explicit MeshDistance(cloud::TriangleMesh mesh);

  /// In the mesh's unit, negative inside.
  double operator()(const Eigen::Vector3d& point) const;

 private:
  struct Node {
    Eigen::Vector3d low, high;
    std::uint32_t first = 0;  ///< of order_, in a leaf
    std::uint32_t count = 0;  ///< faces in a leaf; 0 = not a leaf: children are the next node and `right`
    std::uint32_t right = 0;
  };

  std::uint32_t build(std::uint32_t first, std::uint32_t count);
  void make_pseudonormals();

  cloud::TriangleMesh mesh_;
  std::vector<std::uint32_t> order_;  ///< faces, leaf by leaf
  std::vector<Node> nodes_;
  std::vector<Eigen::Vector3d> face_normals_;
  std::vector<std::array<Eigen::Vector3d, 3>> edge_normals_;  ///< of a face's edges: corner 0 to 1, 1 to 2, 2 to 0
  std::vector<Eigen::Vector3d> vertex_normals_;
};

}  // namespace isotouch::evaluate
