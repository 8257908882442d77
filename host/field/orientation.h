/// Which way normals point, when the file does not say or contradicts itself.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <vector>

#include "host/field/scan.h"

namespace isotouch::field {

/// The normals of paraboloids through the nearest points, of any sign.
///
/// points    at least 3, not all at one place
/// returns   unit vectors, one a point
/// source    Hoppe, DeRose, Duchamp, McDonald, Stuetzle, Surface reconstruction from unorganized points, 1992
std::vector<Eigen::Vector3d> estimated_normals(const std::vector<Eigen::Vector3d>& points);

/// How two normals at neighbouring places agree: 1 where both lie on one circle through the two places and point to the same side of it, -1 to
/// opposite sides, near 0 where nobody can tell. Two sides of a thin part, back to back, agree.
///
/// source    reflection at the plane between the two places: König and Gumhold, Consistent propagation of normal orientations in point clouds, 2009
double agreement(const Eigen::Vector3d& normal, const Eigen::Vector3d& other, const Eigen::Vector3d& step);

/// Of the pairs of neighbours whose agreement is clear, the share that contradicts itself: 0 in a sound scan, one half where signs are random.
double contradictions(const Scan& scan);

/// Of the pairs that contradict themselves, those whose samples lie behind each other less those that lie before each other, as a share of the clear
/// pairs. Where signs are random neither is more frequent. The two sides of a wall that is thinner than the samples are apart lie behind each
/// other: 1 / 2 or more of the pairs there. If such a scan is inside out, it is as much below 0.
double behind_each_other(const Scan& scan);

/// Turns normals until neighbours agree. Samples are joined to parts, clearest agreements first; two parts that meet are turned against each other as
/// all pairs between them ask for. Then parts that all their neighbours ask to turn are turned, until none is left. In every connected part at least
/// half of the normals stay.
///
/// heard     the normals' signs are right more often than not: their votes count beside the pairs, the less the more they contradict each other
/// returns   how many were turned
std::size_t orient_by_neighbours(Scan& scan, bool heard);

/// 98 directions all round, one of each two opposite ones: those of the lattice points in [-2, 2]³ that see the origin.
std::vector<Eigen::Vector3d> half_directions();

/// What a scan as a whole says about its outside.
struct Facing {
  static constexpr double kClosed = 0.2;        ///< of `one_sided`
  static constexpr double kOutward = 0.2;       ///< of `outward`, to believe it
  static constexpr double kClearVote = 0.6;     ///< of the same, to turn all normals
  static constexpr double kClearVolume = 0.04;  ///< of `volume`; signs by chance give a fiftieth, a plate of a fortieth of its length 0.1

  double outward = 0;  ///< 1: the outermost points' normals all point out, -1: all in, near 0: nobody can tell
  double volume =
      0;  ///< that the surface encloses, by the divergence theorem, over that of the ball with its area; negative when it is inside out
  double area = 0;       ///< of the surface, the points' unit squared
  double enclosed = 0;   ///< that volume itself, the points' unit cubed
  double one_sided = 0;  ///< length of the mean normal, weighted by area: 0 for a closed surface, 1 for a flat sheet
  Eigen::Vector3d front = Eigen::Vector3d::Zero();  ///< unit, the mean normal's direction; zero where there is none

  bool is_closed() const { return one_sided < kClosed; }
  bool is_outward() const { return outward > kOutward && volume > kClearVolume; }
  bool is_inward() const { return outward < -kClearVote && volume < -kClearVolume; }
};
Facing facing(const Scan& scan);

}  // namespace isotouch::field
