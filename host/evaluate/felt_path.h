/// One hand that touches a true surface: where it is in each tick, and where the exact god-object rests then.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "host/evaluate/god_object.h"
#include "host/field/triangle_tree.h"
#include "shared/units.h"
#include "shared/vec3.h"

namespace isotouch::evaluate {

struct FeltTick {
  Vec3<Mm> hip;         ///< as a trace holds it
  Eigen::Vector3d god;  ///< mm; the HIP where nothing is touched
  bool touching;
};

/// A hand is made by steps of 1 ms. It may look at what its god-object does, so that it stays on the surface.
class FeltPath {
 public:
  /// tree      closed, workspace, mm; stays alive as long as this
  /// start     outside the body
  FeltPath(const field::TriangleTree& tree, const Eigen::Vector3d& start);

  /// Moves there within this tick.
  void step(const Eigen::Vector3d& hip);
  /// Straight, so many mm a tick; ends exactly there.
  void move(const Eigen::Vector3d& to, double mm_per_tick);
  void hold(int ticks);

  const Eigen::Vector3d& hip() const { return hip_; }
  const Eigen::Vector3d& god() const { return object_.position(); }
  bool touching() const { return object_.touching(); }
  std::vector<FeltTick> take() { return std::move(ticks_); }

 private:
  GodObject object_;
  Eigen::Vector3d hip_;  ///< as it was asked for; the god-object gets the rounded one
  std::vector<FeltTick> ticks_;
};

/// Steers a hand along the surface at a wanted depth, as a person does who feels it: by the god-object's direction in contact, by the nearest place
/// of the surface where there is none.
class SteeredHand {
 public:
  /// path      at its start, near the surface
  /// outward   unit, of the surface there
  /// heading   any direction that is not along it
  SteeredHand(const field::TriangleTree& tree, FeltPath& path, const Eigen::Vector3d& outward, const Eigen::Vector3d& heading);

  /// One tick. The frame turns with the surface: `ahead` goes along the heading, `aside` across it, to the left seen from outside.
  ///
  /// ahead, aside   mm in this tick
  /// depth          of the HIP below the god-object, mm, to be reached in a few ticks
  void step(double ahead, double aside, double depth);
  /// Turns the heading to the left by this tangent.
  void turn(double tangent);
  /// No sideways motion until the depth is reached.
  void sink(double depth);

  const Eigen::Vector3d& outward() const { return outward_; }
  const Eigen::Vector3d& heading() const { return heading_; }
  Eigen::Vector3d aside() const;

 private:
  const field::TriangleTree& tree_;
  FeltPath& path_;
  Eigen::Vector3d outward_, heading_;
};

}  // namespace isotouch::evaluate
