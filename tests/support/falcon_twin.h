/// The Falcon's mechanism in double precision, from its definition and the published lengths: the twin of the core's integer kinematics.
///
/// source    R. E. Stamper 1997, chapter 3, in the notation of SPEC.md 5; Martin and Hillier 2009
#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "shared/device_model.h"
#include "tests/support/random.h"

namespace isotouch::test {

using Angles = std::array<double, 3>;  ///< radians, legs 1 to 3

/// Lengths in mm, angles in radians.
struct FalconTwin {
  double a, b, c, d_plus_e, f, r, s;
  double kappa_sign;  ///< +1: κ = f - s; -1: κ = s - f
  double radians_per_count;
  double radians_at_zero;
  double newton_mm_per_word;

  /// From grip to arm angles, elbow-out branch; none where the arms do not reach.
  std::optional<Angles> inverse(const Point& grip) const;
  /// From arm angles to grip by Newton's iteration; none where it does not converge.
  std::optional<Point> forward(const Angles& angles, const Point& start = {0, 0, 110}) const;
  /// Rows ∂θ/∂p in rad/mm, by the published closed form.
  std::array<Point, 3> jacobian(const Point& grip, const Angles& angles) const;
  /// Arm torques in N·mm that put a force on the hand: Jᵀτ = F.
  Angles torques(const Point& grip, const Angles& angles, const Point& force) const;

  Angles angles_of(const std::array<std::int16_t, 3>& counts) const;
  Angles counts_of(const Angles& angles) const;
};

FalconTwin libnifalcon_twin();
FalconTwin martin_hillier_twin();

struct FalconSet {
  const char* name;
  FalconTwin twin;
  DeviceModel model;
};
/// Both published sets with their integer models.
std::array<FalconSet, 2> falcon_sets();

/// The solution of the 3×3 system with these rows.
Point solve(const std::array<Point, 3>& rows, const Point& right);

/// Counts nearest to where the grip is; none where the arms do not reach or a count leaves ±`limit`.
std::optional<std::array<std::int16_t, 3>> nearest_counts(const FalconTwin& twin, const Point& grip, double limit = 1600);

}  // namespace isotouch::test
