/// The triangles of a mesh, sorted for questions about places: what is nearest, what does a line meet, what lies in a box.
///
/// A binary tree of boxes in one array: the faces are sorted along a space-filling curve and the tree halves that order, so building is a sort and
/// one pass. Same answers on every machine: ties go to the face that comes first on the curve, and the curve breaks ties by the face's number.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "host/cloud/mesh.h"
#include "host/field/on_triangle.h"

namespace isotouch::field {

class TriangleTree {
 public:
  struct Box {
    Eigen::Vector3d low, high;  ///< low > high: empty
    double squared_distance(const Eigen::Vector3d& p) const { return (low - p).cwiseMax(p - high).cwiseMax(0).squaredNorm(); }
  };

  /// mesh      borrowed: it stays alive and unchanged as long as this is used; at least one face
  explicit TriangleTree(const cloud::TriangleMesh& mesh);

  struct Foot {
    Eigen::Vector3d point;
    double distance;  ///< in the mesh's unit
    std::uint32_t face;
    int feature;  ///< as in OnTriangle
  };
  /// The nearest place of the mesh; or, to save time, any place of it that is within `enough`.
  ///
  /// first     a face to begin with: quick when it is near
  Foot nearest(const Eigen::Vector3d& point, double enough = 0, std::uint32_t first = 0) const;

  /// Calls use(face) for every face in a leaf whose box, as all boxes above it, satisfies `meets(box)`. Nearer-to-the-root boxes are asked first;
  /// `meets` may become stricter on the way.
  template <class Meets, class Use>
  void visit(const Meets& meets, const Use& use) const {
    std::array<std::size_t, 64> waiting;  // at most one a level
    std::size_t count = 0;
    waiting[count++] = root();
    while (count > 0) {
      const std::size_t node = waiting[--count];
      if (is_empty(node) || !meets(box(node))) continue;
      if (is_leaf(node)) {
        for (const std::uint32_t face : faces(node)) use(face);
      } else {
        waiting[count++] = 2 * node + 1;
        waiting[count++] = 2 * node;
      }
    }
  }

  Corners corners(std::uint32_t face) const {
    const auto& [a, b, c] = mesh_.faces[face];
    return {mesh_.vertices[a], mesh_.vertices[b], mesh_.vertices[c]};
  }
  const cloud::TriangleMesh& mesh() const { return mesh_; }

  // The tree itself: node n has the children 2n and 2n + 1.
  static std::size_t root() { return 1; }
  bool is_leaf(std::size_t node) const { return node >= leaves_; }
  bool is_empty(std::size_t node) const { return !(boxes_[node].low.x() <= boxes_[node].high.x()); }
  const Box& box(std::size_t node) const { return boxes_[node]; }
  std::span<const std::uint32_t> faces(std::size_t leaf) const;

 private:
  static constexpr std::size_t kLeafFaces = 4;

  const cloud::TriangleMesh& mesh_;
  std::vector<std::uint32_t> order_;  ///< faces along the curve
  std::size_t leaves_ = 1;            ///< a power of two; the first leaf's node
  std::vector<Box> boxes_;
};

}  // namespace isotouch::field
