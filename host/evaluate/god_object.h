/// The god-object on triangles: what everybody else renders meshes with, exact and in doubles. Here it is the virtual object of a simulated scan.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>

#include "host/field/triangle_tree.h"

namespace isotouch::evaluate {

/// The point on or outside a closed mesh nearest to the hand that can be reached by sliding: each step goes straight towards the best point that
/// the planes met so far allow, as far as no further face is met, whose plane then counts too.
///
/// exact     the best point under all planes met in a tick: of the sets of up to three planes the one whose point keeps to all others and pushes
///           off each of its own, as Lagrange's multipliers ask
/// never     passes a face: every step ends kGap before the first one in its way, and each face reaches a quarter of kGap beyond its edges
/// source    Zilles and Salisbury, "A constraint-based god-object method for haptic display", IROS 1995
class GodObject {
 public:
  /// How far in front of a face it stays, as a share of the mesh's largest extent: far above what doubles round, far below what a hand feels.
  static constexpr double kGap = 1e-10;

  /// tree      stays alive as long as this; the mesh is closed
  /// start     outside
  GodObject(const field::TriangleTree& tree, const Eigen::Vector3d& start);

  /// Follows the hand for one tick and returns where it is. On a convex place it may stop in front of the face that it came to beyond an edge.
  const Eigen::Vector3d& follow(const Eigen::Vector3d& hip);
  /// Follows again and again, at most 1,000 times, until nothing brings it nearer to the hand: converged in this tick, also on convex places. Where the
  /// planes hold it at a corner, it also tries the way along each face that meets there, because such a plane goes on beyond its face. It goes along
  /// that face as far as the way is free.
  const Eigen::Vector3d& settle(const Eigen::Vector3d& hip);

  const Eigen::Vector3d& position() const { return position_; }
  /// Faces held it in the last tick.
  bool touching() const { return plane_count_ > 0; }

 private:
  struct Plane {
    Eigen::Vector3d normal;  ///< unit, outward
    double height;           ///< normal · x of the places kGap in front of the face
  };
  static constexpr std::size_t kPlanes = 10;  ///< met in one tick; then the rest of the way waits for the next

  struct Obstacle {
    double share;  ///< of the way; below zero where it is nearer than kGap
    Plane plane;
  };
  bool first_on_way(const Eigen::Vector3d& way, Obstacle& found) const;
  Eigen::Vector3d best_under_planes(const Eigen::Vector3d& hip) const;
  bool leave_corner(const Eigen::Vector3d& hip);

  const field::TriangleTree& tree_;
  double gap_;
  Eigen::Vector3d position_;
  std::array<Plane, kPlanes> planes_;
  std::size_t plane_count_ = 0;
};

}  // namespace isotouch::evaluate
