/// A tree of boxes round a mesh's faces: what every question about what is near walks down.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "host/cloud/mesh.h"
#include "host/field/on_triangle.h"
#include "host/field/simd.h"

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
  Part whole() const { return {{static_cast<std::uint32_t>(nodes_.size() - 1)}, 1}; }
  /// The part that holds all faces within a distance: for many questions from the same region.
  Part part(const Eigen::Vector3d& point, double distance) const;

  /// The nearest place of a part's faces, and of equally near ones that of the first face. The answer does not depend on where the search begins.
  ///
  /// begin     a face, the nearer the quicker
  Place nearest(const Eigen::Vector3d& point, std::uint32_t begin, const Part& part) const;
  Place nearest(const Eigen::Vector3d& point) const { return nearest(point, near(point), whole()); }

  /// Calls use(face) for every face of a part within a distance, and for some that are farther. The square of the distance may shrink on the way.
  template <class Use>
  void each_near(const Eigen::Vector3d& point, const double& square, const Part& part, const Use& use) const;

  /// A face that is near, but maybe not the nearest.
  std::uint32_t near(const Eigen::Vector3d& point) const;

  const std::vector<Face>& faces() const { return faces_; }

 private:
  using Point = std::array<Four, 3>;  // the same in every lane

  /// The boxes of four children, one a lane. They are a little larger than what they hold, so that rounding to floats never makes a face seem farther
  /// away than it is. Lanes without a child hold a box that is infinitely far away.
  struct Node {
    std::array<Four, 3> middle;
    std::array<std::array<Four, 3>, 3> axes;  ///< unit
    std::array<Four, 3> half;                 ///< of the sides, along these
    std::uint32_t first;                      ///< of four nodes; in a leaf, of four faces

    Four squares_to(const Point& point) const;
    /// The lanes that may hold something at this squared distance or nearer.
    unsigned near(const Point& point, double square) const {
      return true_lanes(squares_to(point) <= static_cast<float>(square) * (1 + 2e-6F));
    }
  };

  static Point to_lanes(const Eigen::Vector3d& point) {
    return {all(static_cast<float>(point.x())), all(static_cast<float>(point.y())), all(static_cast<float>(point.z()))};
  }
  void add_level(std::size_t held, std::size_t count, std::uint32_t first, double slack);
  Place on_face(const Eigen::Vector3d& point, std::uint32_t face) const;

  std::vector<Face> faces_;  ///< in the order of the leaves
  std::vector<Node> nodes_;  ///< the leaves first, the root last
  std::size_t leaves_ = 0;
};

/// Squared distances; rounding makes none too large by more than a 2e-6th.
inline Four FaceTree::Node::squares_to(const Point& point) const {
  const std::array<Four, 3> way = {point[0] - middle[0], point[1] - middle[1], point[2] - middle[2]};
  Four sum{};
  for (std::size_t a = 0; a < 3; ++a) {
    const Four along = way[0] * axes[a][0] + way[1] * axes[a][1] + way[2] * axes[a][2];
    const Four outside = larger(magnitude(along) - half[a], Four{});
    sum += outside * outside;
  }
  return sum;
}

template <class Use>
void FaceTree::each_near(const Eigen::Vector3d& point, const double& square, const Part& part, const Use& use) const {
  const Point at = to_lanes(point);
  std::array<std::uint32_t, 64> waiting;  // a part and three a level: 16 levels hold every mesh
  std::size_t count = part.count;
  std::copy_n(part.nodes.begin(), count, waiting.begin());
  while (count > 0) {
    const std::uint32_t number = waiting[--count];
    for (unsigned lanes = nodes_[number].near(at, square); lanes != 0; lanes &= lanes - 1) {
      const std::uint32_t child = nodes_[number].first + static_cast<std::uint32_t>(std::countr_zero(lanes));
      if (number < leaves_)
        use(child);
      else
        waiting[count++] = child;
    }
  }
}

}  // namespace isotouch::field
