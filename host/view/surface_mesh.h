/// The zero surface as few smooth triangles, for a screen that draws it many times a second. `evaluate/zero_surface.h` is the one to measure by.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "host/field_file/marks.h"
#include "shared/field_view.h"

namespace isotouch::view {

struct SurfaceMesh {
  std::vector<Eigen::Vector3f> positions;           ///< workspace, mm
  std::vector<Eigen::Vector3f> normals;             ///< outward, unit
  std::vector<std::uint8_t> invented;               ///< 1: nobody scanned this place
  std::vector<std::array<std::uint32_t, 3>> faces;  ///< counter-clockwise seen from outside
  int step = 1;                                     ///< voxels from one lattice point to the next
};

/// One vertex in each lattice cube that the surface passes through, moved onto the zero of the core's own samples, with their gradient as its normal.
///
/// vertices  at most about as many: the lattice has a step of one voxel, or of two or four where that would give more
/// bounded   what is thinner than the step may be missed
/// source    surface nets: S. Gibson, MICCAI 1998
SurfaceMesh surface_mesh(const FieldView& field, const field_file::Marks& invented, std::size_t vertices);

}  // namespace isotouch::view
