/// Where a god-object could as well rest elsewhere: hands near the middle between two walls.
#pragma once

#include <Eigen/Core>

#include "host/field/triangle_tree.h"

namespace isotouch::evaluate {

/// Two places are equally near if their distances from the hand differ by at most this share, or by this many millimetres.
inline constexpr double kEqualShare = 0.1;
inline constexpr double kEqualMm = 0.05;
/// Directions that differ by less are one answer. If they differ by more than the second, the place lies on the other side of a part, where a
/// god-object cannot get.
inline constexpr double kOtherDirectionDeg = 20;
inline constexpr double kOtherSideDeg = 120;

/// Is there another place on the surface, in another direction, which is as near to the hand as the god-object, and at which a god-object could rest?
///
/// tree      closed, mm
/// hip       inside, or behind a thin part
/// place     where the god-object rests
/// returns   true if a face, edge or corner within the tolerances above is nearer to the hand than everything round it, and the hand is behind it
bool has_equal_answer(const field::TriangleTree& tree, const Eigen::Vector3d& hip, const Eigen::Vector3d& place);

}  // namespace isotouch::evaluate
