/// What a hand does with an object. Each gesture comes from outside, touches, and goes outside again.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "host/cloud/random.h"
#include "host/motion/felt_surface.h"
#include "host/motion/hand.h"

namespace isotouch::motion {

/// A hand at an object. Depths are in the object's voxels, speeds in mm/s; places are drawn from `random`.
///
/// Between touches the hand travels on a ball around the object, and reaches every place by a way that it has looked along: it is free.
class Gestures {
 public:
  /// surface   stays alive as long as this
  /// fails     InputError when the object cannot be found: no way from outside meets it
  Gestures(const FeltSurface& surface, Hand& hand, cloud::Random random);

  /// Along the normal 1 to 6 voxels in, a rest, and out, slowly.
  void press();
  /// 4 voxels deep over the surface for 1.5 s, turning a little, at 100, 300 or 1000 mm/s.
  void slide();
  /// Eight quick taps, 1 to 3 voxels deep, at 200 to 500 mm/s.
  void tap();
  /// A press with a small stir where the field is bent most: at edges, corners and creases.
  void corner();
  /// Over the surface at 30 mm/s while going in and out by 0.1 voxel.
  void graze();
  /// Straight through, thin places first, at 0.3 to 1 m/s, at least 20 voxels beyond; a rest, and back the same way.
  void stab();
  /// Out of the grid during contact and through the object, past ±512 mm, and back.
  void leave();

 private:
  struct Place {
    Eigen::Vector3d from;  ///< on the ball around the object
    SurfacePoint at;
  };

  Eigen::Vector3d draw();
  Eigen::Vector3d direction();
  std::optional<Place> look();
  Place any_place();
  void travel(const Eigen::Vector3d& to);
  void approach(const Place& place, double clearance);
  void retreat(const SurfacePoint& from);
  void glide(const Place& place, double speed, double seconds, double depth, double ripple);

  const FeltSurface& surface_;
  Hand& hand_;
  cloud::Random random_;
  double voxel_;
  double radius_;                  ///< of the ball on which the hand travels
  std::vector<Place> bent_;        ///< most bent first
  std::vector<Place> thin_;        ///< thinnest first
  std::vector<double> thickness_;  ///< of them, mm
};

}  // namespace isotouch::motion
