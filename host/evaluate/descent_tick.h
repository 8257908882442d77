/// The published proxy and force in single precision: the tick that ours is timed with, and what `core::descend_proxy` is compared with.
///
/// Sreeni minimises Ψ = ½|X_p − X_h|² + (λ/2) φ(X_p)² by gradient descent with a fixed step (3.3, equations 5 to 9):
///
///     X_p ← X_p − γ (X_p − X_h) − γ λ φ(X_p) ∇φ(X_p),      f = −k (X_h − X_p)
///
/// γ, λ, the number of steps and k are not given. Ours, in voxels and levels, are those of the controller:
///
///   λ = 10            At rest the proxy stays 1 / (1 + λ|∇φ|²) of the depth below the surface, and the force is short by that share:
///                     9 % where a level is a voxel, 3 % along a diagonal. The levels' zero is half a voxel inside, 12 % of the force at
///                     a depth of 4. On a sphere of 80 voxels the force is short by 17, 14 and 13 % for λ = 10, 30 and 100, its direction
///                     off by 7.9° rms for each, at 1, 3 and 10 times the cost: the levels decide, not λ.
///   γ = 1 / (1 + 3λ)  Along the gradient a step multiplies the error by 1 − γ(1 + λ|∇φ|²), which must stay within ±1. Peeling with 6
///                     neighbours counts Manhattan distance, so |∇φ|² ≤ 3: with this γ the factor is within [0, 1), without overshoot,
///                     and no larger γ has that.
///   143 steps         Along the surface the error shrinks by 1 − γ a step, and (1 − γ)^143 = 0.01: a tick takes away 99 % of what the
///                     hand has moved.
///   k                 the field's stiffness; the K(x, y, z) of section 2.1 is a constant here.
#pragma once

#include <Eigen/Core>

#include "firmware/core/descent_proxy.h"
#include "host/published/level_field.h"

namespace isotouch::evaluate {

class DescentTick {
 public:
  /// levels       stays alive and unchanged
  /// stiffness    N/mm
  DescentTick(const published::LevelField& levels, float stiffness);

  /// One tick: where the hand is → the force on it.
  ///
  /// hip       workspace, mm; beyond the grid there is no contact
  /// returns   N; zero where φ ≥ 0 at the proxy, and there the proxy is the HIP
  /// fails     never
  Eigen::Vector3f force(const Eigen::Vector3f& hip);

  /// workspace, mm
  Eigen::Vector3f proxy() const { return origin_ + edge_ * proxy_; }

 private:
  static constexpr float kLambda = core::kDescentPenalty;
  static constexpr float kGamma = 1 / (1 + 3 * kLambda);

  const published::LevelField& levels_;
  Eigen::Vector3f origin_;
  float edge_;
  float stiffness_;
  Eigen::Vector3f proxy_ = Eigen::Vector3f::Zero();  // index coordinates
  bool inside_ = false;
};

/// φ and ∇φ at a point in index coordinates: φ trilinear over the 8 nodes around it, ∇φ trilinear over the central differences at these
/// nodes. Points nearer than one node to the grid's border are outside: level 1, no gradient.
struct LevelSample {
  float level;
  Eigen::Vector3f gradient;
};
LevelSample sample_levels(const published::LevelField& levels, const Eigen::Vector3f& point);

}  // namespace isotouch::evaluate
