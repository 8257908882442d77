/// The exact signed distance to a closed triangle mesh.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "host/cloud/mesh.h"
#include "host/field/face_crossings.h"
#include "host/field/face_tree.h"
#include "host/field/winding_number.h"

namespace isotouch::field {

/// The nearest place of the mesh is found through a tree of boxes. The sign is the side of the pseudonormal there: of the face, the sum of both
/// faces' at an edge, the sum weighted by the angles at a corner. That is right for every mesh whose edges have two faces each and that does not run
/// through itself. On any other, inside is where the winding number is above 1/2: the union of what its parts enclose.
///
/// source    Bærentzen and Aanæs, "Signed distance computation using the angle weighted pseudonormal", IEEE TVCG 11(3), 2005;
///           nearest point of a triangle: Ericson, Real-Time Collision Detection, 2005, section 5.1.5
class MeshDistance {
 public:
  /// mesh      closed: every edge is run as often in one direction as in the other; at least one face, no face without area (it counts as its
  ///           longest edge's length, with no direction of its own)
  explicit MeshDistance(cloud::TriangleMesh mesh);
  MeshDistance(const MeshDistance&) = delete;
  MeshDistance& operator=(const MeshDistance&) = delete;

  /// In the mesh's unit, negative inside. May be called from several threads.
  double operator()(const Eigen::Vector3d& point) const;

  /// The same at the 4x4x4 points first + step * (i, j, k), x fastest: each search begins with the face that was nearest to the last point.
  std::array<double, 64> distances(const Eigen::Vector3d& first, double step) const;

  const cloud::TriangleMesh& mesh() const { return mesh_; }
  const FaceCrossings& crossings() const { return crossings_; }

 private:
  /// The nearest place that is known so far.
  struct Found {
    double square;
    Eigen::Vector3d offset;  ///< from it to the point
    std::uint32_t face;      ///< in the tree
    int feature;             ///< 0 to 2 a corner, 3 to 5 an edge (corner 0 to 1, 1 to 2, 2 to 0), 6 the face
  };

  Found on_face(const Eigen::Vector3d& point, std::uint32_t face) const;
  Found nearest(const Eigen::Vector3d& point, Found best) const;
  bool behind(const Found& found) const;
  bool make_pseudonormals();

  cloud::TriangleMesh mesh_;
  FaceTree tree_;
  std::vector<std::array<Eigen::Vector3d, 4>> normals_;  ///< of a face's three edges and of itself, in the mesh's order
  std::vector<Eigen::Vector3d> vertex_normals_;
  FaceCrossings crossings_;
  std::optional<WindingNumber> winding_;  ///< where pseudonormals do not tell
};

}  // namespace isotouch::field
