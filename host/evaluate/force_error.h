/// The paper's Fig. 9 by numbers: the force while a hand slides inside a sphere, against the exact answer.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <functional>
#include <vector>

#include "shared/field_view.h"

namespace isotouch::evaluate {

/// HIP, mm, workspace → force, N; called once a tick, in order.
using ForceTick = std::function<Eigen::Vector3d(const Eigen::Vector3d&)>;

struct SphereSlide {
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();  ///< mm
  double radius = 1;                                 ///< mm
  double depth = 0.05;                               ///< mm below the surface
  double speed = 100;                                ///< mm/s of the HIP
  double stiffness = 0.8;                            ///< N/mm, of the exact answer
  double period_s = 0.001;
  double turns = 3;  ///< round the sphere
};

struct ForceSample {
  double time = 0;        ///< s since the hand was at depth
  Eigen::Vector3d felt;   ///< N
  Eigen::Vector3d exact;  ///< N: stiffness times depth, radially out
};

struct ForceError {
  std::size_t ticks = 0;
  double magnitude_rms_pct = 0;  ///< of the exact magnitude
  double direction_max_deg = 0;  ///< the worst tick; 180 where no force was felt
};

/// Comes from outside at 25 mm/s, rests for 0.1 s, then goes round on a tilted, slowly turning great circle, its speed rising in 0.1 s.
///
/// returns   every tick after touch-down and rest
std::vector<ForceSample> slide_on_sphere(const SphereSlide& slide, const ForceTick& tick);

/// fails     InputError when there are no samples
ForceError force_error(const std::vector<ForceSample>& samples);

/// The core's tick on a field, as a ForceTick; pure spring, no force limit below 100 N.
///
/// field     stays alive as long as the result
ForceTick core_force(const FieldView& field, double period_s = 0.001);

}  // namespace isotouch::evaluate
