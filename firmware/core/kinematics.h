/// Forward kinematics of the delta mechanism: arm angles → HIP, and the matrices that turn a force on the hand into arm torques.
///
/// Each leg closes: (A - a cosθ)² + (z - a sinθ)² = E², with A the grip's joint along the leg's azimuth, q across it, E = d + e + √(b² - q²). With
///
///     X = A - a cosθ     Z = z - a sinθ     G = X û + (E q / √(b² - q²)) v̂ + Z ẑ     d = a (Z cosθ - X sinθ)
///
/// G is half the gradient of the closure, and J = G / d is the row ∂θ/∂p of the Jacobian. One inverse of the matrix of the three G therefore serves
/// both: Newton's step on the closures and, with the levers d, the torques. No row has to be divided by its lever.
///
/// The closures may hold at a second place, to which no movement of the arms leads: between them the mechanism is singular, and the determinant of the
/// three G changes its sign. In the workspace it is negative for legs that follow each other
/// from y towards x, as a Falcon's do. The other place is none of the grip.
///
/// source    R. E. Stamper 1997, chapter 3; the z column with sinθ2·sinθ3 (his equation 4.12)
#pragma once

#include <array>
#include <cstdint>

#include "firmware/core/joint_angles.h"
#include "shared/angle.h"
#include "shared/device_model.h"
#include "shared/units.h"
#include "shared/vec3.h"

namespace isotouch::core {

/// Newton's steps a tick: two bring the HIP there, the third confirms it.
inline constexpr int kPoseSteps = 3;

/// The model as the steps need it, see `make_mechanism`.
struct Mechanism {
  Mm arm;
  Mm joint;
  std::int64_t radial = 0;      ///< mm, 52 fraction bits, half a unit of Mm added: the upper word of a sum that begins with it is rounded
  std::int64_t tangential = 0;  ///< the same
  Mm reach_across;              ///< |q| stays below 0.99 b
  std::int64_t rod_square = 0;  ///< b², mm², 40 fraction bits
  std::array<SineCosine, 3> azimuths{};
  bool clockwise = false;  ///< legs 1, 2 and 3 follow each other from y towards x
};

/// tick      yes
Mechanism make_mechanism(const DeviceModel& device);

using PerMm = Fixed<Unit<-1, 0, 0, 0>, 27>;    ///< range ±15.9 / mm
using SquareMm = Fixed<Unit<2, 0, 0, 0>, 12>;  ///< range ±524,287 mm²

/// The inverse of the three closures' gradients, and the levers: τ = levers · (inverse · F).
struct Statics {
  std::array<Vec3<PerMm>, 3> inverse{};  ///< column i of the inverse of the matrix whose rows are G
  std::array<SquareMm, 3> levers{};      ///< d, above 0 where the elbows point out
  bool near_singular = false;            ///< det G below 50,000 mm³: the inverse is taken for that determinant, so it is too small
};

struct Pose {
  Vec3<Mm> hip;          ///< device frame
  Statics statics;       ///< at the HIP before the confirming step
  bool settled = false;  ///< the confirming step was below 1 µm, inside the model, twice in a row
};

/// The grip's middle, from where every pose of the workspace is found.
inline constexpr Vec3<Mm> kPoseStart = {Mm{}, Mm{}, Mm::of(110)};

struct PoseState {
  Vec3<Mm> hip = kPoseStart;
  std::uint32_t confirmed = 0;  ///< ticks in a row whose last step was short, at most 2
  std::uint32_t lost = 0;       ///< ticks in a row whose last step was not
};

/// Follows the grip: kPoseSteps of Newton's iteration from the last HIP; a default state is a cold start, settled after 2 to 10 ticks within
/// 90 mm of the axis.
///
/// returns   where settled, HIP within 0.05 µm of the exact solution for |q| < 0.98 b and poses that are not nearly singular, 0.005 µm within 50 mm of
///           the workspace's centre; a hand of 1 mm a tick stays settled
/// fails     never: outside the model (no solution, |q| beyond 0.99 b, an elbow turned in, the determinant's other sign) it is not settled and begins
///           again every 16 ticks
/// tick      yes: constant cost, no division
Pose follow_pose(const JointAngles& angles, const Mechanism& mechanism, PoseState& state);

}  // namespace isotouch::core
