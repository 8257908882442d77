/// A hand that stays in creases.
#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

#include "host/evaluate/felt_path.h"
#include "host/evaluate/sharp_edges.h"

namespace isotouch::evaluate {

/// Follows concave edges below the surface, at a constant distance from them: where one ends it goes on along the one that leads straightest on, or
/// turns back. It knows both walls, and so it does not climb out of a shallow crease as a hand does that feels only where it is pushed.
class CreaseHand {
 public:
  /// creases   concave; alive as long as this
  /// place     on one of them
  /// path      at its start, in front of the crease
  /// depth     of the hand below the crease, mm
  CreaseHand(const std::vector<SharpEdge>& creases, const EdgePlace& place, FeltPath& path, double depth);

  /// Straight to where the hand is halfway between the walls.
  void sink(double mm_per_tick);
  /// One tick.
  ///
  /// ahead   mm along the crease
  /// side    -1 and 1: below the crease along the normals of its two walls, where a god-object begins to leave it; beyond, it rests on one of them
  void step(double ahead, double side);

 private:
  Eigen::Vector3d below(double side) const;
  void walk(double ahead);

  const std::vector<SharpEdge>& creases_;
  FeltPath& path_;
  double depth_;
  Eigen::Vector3d at_, end_;                ///< on the crease, and where its edge ends
  Eigen::Vector3d start_;                   ///< its other end
  std::array<Eigen::Vector3d, 2> normals_;  ///< of the walls, in the order of the sides
  Eigen::Vector3d way_;                     ///< unit, from the crease to the hand
};

}  // namespace isotouch::evaluate
