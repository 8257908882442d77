/// A closed mesh → its exact distances in a band, by the walk that serves every method.
#pragma once

#include "host/field/band_field.h"
#include "host/field/mesh_distance.h"

namespace isotouch::field {

/// The margin round the mesh, voxels: what `make_grid` should be asked for.
constexpr double mesh_margin(double band) { return band + 3.0; }

/// mesh      workspace, mm
/// grid      leaves at least `mesh_margin` voxels round the mesh on every side
/// band      half width, voxels, 1 to 7.99
/// returns   distances in voxels, true to rounding in every listed brick; the same bits for any number of threads
/// fails     never
BandField mesh_field(const MeshDistance& mesh, const Grid& grid, double band);

}  // namespace isotouch::field
