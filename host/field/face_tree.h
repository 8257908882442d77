/// A tree of boxes round a mesh's faces: what every question about what is near walks down.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "host/cloud/mesh.h"
#include "host/field/face_boxes.h"
#include "host/field/on_triangle.h"

namespace isotouch::field {

/// Each box has axes of its own, the last along the normal of the faces in it. Seen from nearby a surface is flat: there such boxes let in the few
/// faces below a point, where boxes along the coordinates let in all within about the square root of the height.
class FaceTree {
 public:
  struct Face {
    Corners corners;
    std::uint32_t number = 0;  ///< in the mesh
  };

  /// Halves the faces again and again by their middles, along the coordinate in which these spread most; ties by number.
  ///
  /// mesh      at least one face; quickest when it lies about the origin
  explicit FaceTree(const cloud::TriangleMesh& mesh);

  /// A place of the mesh, seen from a point.
  struct Place {
    double square;           ///< of the distance
    Eigen::Vector3d offset;  ///< from it to the point
    std::uint32_t face;      ///< of `faces()`
    int feature;             ///< as in OnTriangle
  };

  /// A part of the tree: a few nodes of one level.
  struct Part {
    std::array<std::uint32_t, 16> nodes;
    std::size_t count;
  };
  Part whole() const { return {{static_cast<std::uint32_t>(leaves_.size() + nodes_.size() - 1)}, 1}; }
  /// The part that holds all faces within a distance: for many questions from the same region.
  Part part(const Eigen::Vector3d& point, double distance) const;

  /// The nearest place of a part's faces, and of equally near ones that of the first face. The answer does not depend on where the search begins.
  ///
  /// begin     a face, the nearer the quicker
  Place nearest(const Eigen::Vector3d& point, std::uint32_t begin, const Part& part) const;
  Place nearest(const Eigen::Vector3d& point) const { return nearest(point, near(point), whole()); }

  /// Calls use(face) for every face within a distance, and for some that are a little farther.
  template <class Use>
  void each_near(const Eigen::Vector3d& point, double distance, const Use& use) const;

  /// A face that is near, but maybe not the nearest.
  std::uint32_t near(const Eigen::Vector3d& point) const;

  const std::vector<Face>& faces() const { return faces_; }

 private:
  /// The boxes of sixteen children, which follow each other.
  struct Node {
    FaceBoxes boxes;
    std::uint32_t first;  ///< number of a node; the leaves are the first ones
  };

  bool is_leaf(std::uint32_t node) const { return node < leaves_.size(); }
  std::uint32_t first_face(std::uint32_t leaf) const { return static_cast<std::uint32_t>(kTogether) * leaf; }
  const Node& inner(std::uint32_t node) const { return nodes_[node - leaves_.size()]; }
  /// Calls use(child) for the children of an inner node within this widened distance.
  template <class Use>
  void each_child(std::uint32_t node, const std::array<float, 3>& point, float square, const Use& use) const {
    for (unsigned bits = within_.boxes(inner(node).boxes, point, square); bits != 0; bits &= bits - 1)
      use(inner(node).first + static_cast<std::uint32_t>(std::countr_zero(bits)));
  }
  /// Calls use(leaf) for the leaves of a part that may hold something within a widened distance, which may shrink on the way.
  template <class Use>
  void each_leaf(const std::array<float, 3>& point, const float& square, const Part& part, const Use& use) const;
  /// What the square of a distance may seem to be after rounding.
  float widened(double distance) const {
    const double wide = distance * (1 + 1e-6) + margin_;
    return static_cast<float>(wide * wide);
  }
  static std::array<float, 3> to_floats(const Eigen::Vector3d& point) {
    return {static_cast<float>(point.x()), static_cast<float>(point.y()), static_cast<float>(point.z())};
  }
  void add_leaves();
  void add_level(std::size_t held, std::size_t count, std::uint32_t first);
  Place on_face(const Eigen::Vector3d& point, std::uint32_t face) const;

  std::vector<Face> faces_;  ///< in the order of the leaves
  std::vector<FlatFaces> leaves_;
  std::vector<Node> nodes_;  ///< the root last
  double margin_ = 0;        ///< what rounding may add to a distance
  FacesWithin within_ = widest_within();
};

template <class Use>
void FaceTree::each_leaf(const std::array<float, 3>& point, const float& square, const Part& part, const Use& use) const {
  std::array<std::uint32_t, 136> waiting;  // a part and fifteen a level: 8 levels hold every mesh
  std::size_t count = part.count;
  std::copy_n(part.nodes.begin(), count, waiting.begin());
  while (count > 0) {
    const std::uint32_t node = waiting[--count];
    if (is_leaf(node))
      use(node);
    else
      each_child(node, point, square, [&](std::uint32_t child) { waiting[count++] = child; });
  }
}

template <class Use>
void FaceTree::each_near(const Eigen::Vector3d& point, double distance, const Use& use) const {
  const std::array<float, 3> at = to_floats(point);
  const float limit = widened(distance);
  each_leaf(at, limit, whole(), [&](std::uint32_t leaf) {
    Row squares;
    for (unsigned bits = within_.faces(leaves_[leaf], at, limit, squares); bits != 0; bits &= bits - 1)
      use(first_face(leaf) + static_cast<std::uint32_t>(std::countr_zero(bits)));
  });
}

}  // namespace isotouch::field
