/// The exact signed distance to a closed triangle mesh.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "host/cloud/mesh.h"
#include "host/field/face_crossings.h"
#include "host/field/face_tree.h"
#include "host/field/triangle_tree.h"

namespace isotouch::field {

/// The nearest place of the mesh is found through a tree of boxes. The sign is the side of the pseudonormal there: of the face, the sum of both
/// faces' at an edge, the sum weighted by the angles at a corner. That is right for every mesh of one piece whose edges have two faces each and whose
/// faces neither cross nor touch. On any other, inside is what the mesh turns round at least once: the union of what its parts enclose; and only the
/// union's surface counts (outer_faces.h): outside, the distance is exact but for the slivers named there; inside, it
/// may be too small by the length given there. A place in a gap or a wall that is too thin to count there is on the side of what is round it.
///
/// source    Bærentzen and Aanæs, "Signed distance computation using the angle weighted pseudonormal", IEEE TVCG 11(3), 2005
class MeshDistance {
 public:
  /// mesh      closed: every edge is run as often in one direction as in the other; at least one face, no face without area (it counts as its
  ///           longest edge's length, with no direction of its own)
  explicit MeshDistance(cloud::TriangleMesh mesh);
  MeshDistance(const MeshDistance&) = delete;
  MeshDistance& operator=(const MeshDistance&) = delete;

  /// In the mesh's unit, negative inside. May be called from several threads.
  double operator()(const Eigen::Vector3d& point) const;

  /// The same at a block of 4x4x4 points and at its middle.
  struct Block {
    double middle;
    std::optional<std::array<double, 64>> points;  ///< x fastest
  };
  /// points    first + step * (i, j, k)
  /// reach     in steps: when the middle is farther from the mesh, the points are left out
  Block block(const Eigen::Vector3d& first, double step, double reach) const;

  const cloud::TriangleMesh& mesh() const { return mesh_; }
  /// The surface that distances are measured to: the mesh's faces but for those inside the union.
  const cloud::TriangleMesh& outer() const { return outer_ ? *outer_ : mesh_; }
  /// Is it one sheet that neither crosses nor touches itself?
  bool is_simple() const { return !turns_; }
  const FaceCrossings& crossings() const { return crossings_; }
  /// If so many faces cross that the outer surface is coarse there: how long its parts are, over the mesh's size (outer_faces.h). Else 0.
  double coarse_parts() const { return coarse_; }

 private:
  bool is_behind(const FaceTree::Place& nearest) const;
  bool is_in(const Eigen::Vector3d& point, const FaceTree::Place& nearest) const;
  /// Is there a hidden face in a box, or so near to it that a gap or a wall between the two would not count? Or in the box round such a face.
  bool any_hidden(const Eigen::Vector3d& low, const Eigen::Vector3d& high) const;
  /// Is a point inside that is `distance` from the surface, beside hidden faces? Most of three places decide: the point, and one on either side of it.
  /// So a point in a gap or a wall that does not count leaves it, and one beside a gap does not get into it.
  ///
  /// is_inside_at    of a place, and which it is: 0 is the point, 1 and 2 are those beside it
  template <class Inside>
  bool most_inside(const Eigen::Vector3d& point, double distance, const Inside& is_inside_at) const;
  bool make_pseudonormals();

  cloud::TriangleMesh mesh_;
  FaceTree tree_;                                        ///< of the outer surface
  std::vector<std::array<Eigen::Vector3d, 4>> normals_;  ///< of a face's three edges and of itself, in the mesh's order
  std::vector<Eigen::Vector3d> vertex_normals_;
  FaceCrossings crossings_;
  std::optional<cloud::TriangleMesh> outer_;  ///< if it is not the mesh itself
  double coarse_ = 0;
  double thinnest_ = 0;                ///< with an outer surface: `kThinnest` of its size
  std::vector<bool> hidden_;           ///< then, of each face: does it not count, or only in part?
  std::optional<TriangleTree> turns_;  ///< of a mesh for which pseudonormals do not decide
};

}  // namespace isotouch::field
