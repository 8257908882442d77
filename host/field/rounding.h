/// Were the coordinates of a scan written with too few digits?
#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

namespace isotouch::field {

/// positions   any length unit, in the file's frame: a rotation hides the steps, and so do two lattices that do not fit
/// returns     the step of which the coordinates of all points but one in fifty differ by whole multiples, the least of the three axes; 0 where an axis has
///             none. Where the points lie in the
///             middle of a lattice's edges or faces, such as the border of a volume of voxels, the lattice's own step, two of these
double rounding_step(const std::vector<Eigen::Vector3d>& positions);

struct AxisStep {
  int axis = 0;
  double step = 0;  ///< 0: none
};

/// returns   the axis with the longest step of those that have one. Its cause may be rounding, or a scanner that takes slices
AxisStep coarsest_axis(const std::vector<Eigen::Vector3d>& positions);

/// positions   any length unit, in the file's frame
/// returns     if all coordinates are 32-bit floats, the step between those as far from the origin as the farthest point, the largest of the three axes;
///             else 0
double float_step(const std::vector<Eigen::Vector3d>& positions);

/// Up to which rounding the points of a scan without normals tell their surface, voxels: at 4.0 two of four bodies had 2 % of their places on the wrong side,
/// at 2.0 none of four.
inline constexpr double kMostRoundedOfEstimated = 3.0;

/// Why floats of such a step are refused, and what to do.
std::string floats_too_coarse(double voxels);

}  // namespace isotouch::field
