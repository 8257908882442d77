/// Sound scans made as bad as real ones: points beside the surface, points that belong to nothing, normals the wrong way round.
#pragma once

#include <cstdint>

#include "host/cloud/oriented_points.h"

namespace isotouch::evaluate {

struct Damage {
  const char* name;  ///< for people and JSON
  double noise = 0;  ///< standard deviation of every coordinate, in median spacings
  double strays =
      0;  ///< points added, a share of those there are: anywhere in the points' box and a tenth of its longest side round it, normals
          ///< in any direction
  double turned = 0;  ///< normals turned round, a share of all
};

/// What the evaluation does to its clouds: each kind alone, then all of them.
inline constexpr Damage kDamages[] = {{"noise", 0.02, 0, 0}, {"outliers", 0, 0.01, 0}, {"flipped", 0, 0, 0.06}, {"all", 0.02, 0.01, 0.06}};

/// The share of the longest side that strays may lie beside the box.
inline constexpr double kStrayMargin = 0.1;

/// points    any length unit; at least 2
/// returns   the points in their order, the strays behind them; the same for a seed on every machine, and each kind of damage the same beside others
///           as alone
cloud::OrientedPoints damaged(const cloud::OrientedPoints& points, const Damage& damage, std::uint64_t seed);

}  // namespace isotouch::evaluate
