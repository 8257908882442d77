/// The points of a cell that stand for the others in it.
#pragma once

#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "host/cloud/oriented_points.h"
#include "host/field/cell_order.h"

namespace isotouch::field {

struct Thinned {
  static constexpr std::uint32_t kStray = std::numeric_limits<std::uint32_t>::max();

  cloud::OrientedPoints samples;         ///< cell by cell
  std::vector<std::uint32_t> point;      ///< which point each sample is
  std::vector<std::uint32_t> sample_of;  ///< of the n-th point in the order: the sample that stands for it, or kStray
};

/// Keeps one point of every group that shares a cell and a direction: the one nearest to the group's mean, so no sample is moved off the surface;
/// its stiffness is the group's mean.
/// A group whose normals oppose one three times its size is taken for stray normals and left out; two sides of a thin part, of like size, both stay.
/// One or two points beside a group at least as large that looks elsewhere are left out too, and that group stands for them: next to an edge, noise
/// decides whether they make it convex or concave. If its model does not explain them, the cell is cut and they stay.
///
/// points    index coordinates, voxels; unit normals
/// order     of the points
/// cells     along the order, together all points
/// source    voxel-grid filter with normals
Thinned thinned(const cloud::OrientedPoints& points, const CellOrder& order, std::span<const Cell> cells);

}  // namespace isotouch::field
