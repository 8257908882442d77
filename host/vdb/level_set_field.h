/// A level set from another program → a band field.
#pragma once

#include "host/cloud/oriented_points.h"
#include "host/field/band_field.h"
#include "host/vdb/level_set.h"

namespace isotouch::vdb {

/// The level set's own samples, values as they are.
///
/// set       with `samples`
/// placement from its world to the workspace; moved by less than 2^-20 mm so that a field holds the grid exactly
/// band      voxels, at most `set.half_width`
/// fails     never
field::BandField own_field(const LevelSet& set, cloud::Placement& placement, double band);

/// The level set on another grid.
///
/// level_set of `set`
/// grid      leaves at least band + 3 voxels round the surface on every side
/// band      voxels of that grid, at most `known_band`
/// fails     never
field::BandField resampled_field(const Interpolation& level_set, const LevelSet& set, const cloud::Placement& placement,
                                 const field::Grid& grid, double band);

/// How far from the surface a grid of this edge can be filled, in its voxels.
double known_band(const Interpolation& level_set, const LevelSet& set, const cloud::Placement& placement, double edge);

}  // namespace isotouch::vdb
