/// The paper's method from end to end: oriented points → levels on a dense grid. It is the reference that everything else is measured
/// against, so it stays as plain as it is written there: all pairs for the radii, all nodes of every sphere's box, all nodes once a layer.
///
/// source    Sreeni K. G., Distance Field based Haptic Rendering of Scattered Oriented Points, sections 3.1 and 3.2
#pragma once

#include <cstddef>

#include "host/cloud/oriented_points.h"
#include "host/field/band_field.h"
#include "host/field/progress.h"
#include "host/published/level_field.h"

namespace isotouch::published {

struct Built {
  LevelField levels;
  std::size_t inside_nodes = 0;    ///< before the peeling: the paper's Table 1 counts these
  std::size_t without_sphere = 0;  ///< points with no partner below their tangent plane
};

/// The voxels that the grid has beside the cloud's box: spheres may leak out of it by a little, and a field's border is outside.
inline constexpr double kMargin = 4;

/// points    workspace, mm; unit outward normals
/// progress  stages radii, indicator, levels
/// fails     InputError when the grid has more than 2^28 nodes: it is kept dense
Built build(const cloud::OrientedPoints& points, const field::Grid& grid, field::Progress& progress);

/// Levels as distances in voxels, so that a field can be written from them: band 7, one level is one voxel. Outside stays at level 1 up
/// to the two outermost layers, which a field wants far outside.
field::BandField to_band_field(const LevelField& levels);

}  // namespace isotouch::published
