/// Random hands at random walls: does the proxy ever pass one?
///
/// Each body is written by the host as a controller gets it. It divides space into sides that no way round connects within the hand's reach: a thin
/// plate, two or three plates that cross, a hollow object that is felt from within or from without, a solid object. A hand starts on one side and moves at
/// random: straight at up to 1 m/s, in a random walk, at rest, or by a jump of up to 50 voxels in one tick. The proxy must stay on its side.
#pragma once

#include <cstdint>
#include <string>

#include "shared/field_view.h"

namespace isotouch::test {

inline constexpr std::uint64_t kTicksOfAWall = 20'000;  ///< then comes another body

struct WallOptions {
  Interpolation interpolation = Interpolation::kSpline;
  double thinnest = 2, thickest = 6;  ///< of plates and shells, voxels
};

struct WallRun {
  std::uint64_t ticks = 0, touching = 0, bodies = 0;
  std::uint64_t passed = 0;  ///< bodies in which the proxy came to another side; such a body's run ends there
  std::uint64_t jumps = 0;   ///< ticks in which the hand moved by more than 1 mm
  double deepest_voxel = 0;  ///< that a proxy in contact was below the true surface
  double longest_voxel = 0;  ///< way of a proxy from one tick in contact to the next
  std::string first;         ///< the first wall that was passed, for people; empty where none was
};

/// The same for a seed on every machine.
///
/// ticks     at least; whole bodies
WallRun wall_trials(std::uint64_t ticks, std::uint64_t seed, const WallOptions& options);

/// In a line.
std::string describe(const WallRun& run);

}  // namespace isotouch::test
