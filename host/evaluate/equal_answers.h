/// Where a god-object could as well rest elsewhere: hands near the middle between two walls.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <vector>

#include "host/field/triangle_tree.h"

namespace isotouch::evaluate {

/// Two places are equally near if their distances from the hand differ by at most this share, or by this many millimetres.
inline constexpr double kEqualShare = 0.1;
inline constexpr double kEqualMm = 0.05;
/// By how much they may differ where a god-object is so deep, mm.
inline double equal_tolerance(double depth) { return std::max(kEqualMm, kEqualShare * depth); }

/// Directions that differ by less are one answer. If they differ by more than the second, the place lies on the other side of a part, where a
/// god-object cannot get.
inline constexpr double kOtherDirectionDeg = 20;
inline constexpr double kOtherSideDeg = 120;

/// The other places on the surface at which a god-object could rest, in other directions than the one in which it does.
///
/// tree      closed, mm
/// hip       inside, or behind a thin part
/// place     where the god-object rests
/// nearest, farthest   from the hand, mm: what is asked
/// returns   the ways from the hand to them: faces, edges and corners that are nearer to it than everything round them, and that it is behind
std::vector<Eigen::Vector3d> other_answers(const field::TriangleTree& tree, const Eigen::Vector3d& hip, const Eigen::Vector3d& place,
                                           double nearest, double farthest);

}  // namespace isotouch::evaluate
