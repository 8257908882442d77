/// A closed mesh as an object whose surface is known, beside those of `cloud::shape`.
#pragma once

#include <string>

#include "host/cloud/mesh.h"
#include "host/cloud/shapes.h"

namespace isotouch::evaluate {

/// mesh      closed, in any unit; scaled to 186 units along its longest side, as the voxels of the paper's grids, with the middle of its box at the
///           origin
/// name      as it stands in tables
/// returns   exact distances; at an edge the normal of one of the faces that meet there; the volume, exact unless parts of the mesh run through,
///           touch or hold each other
/// fails     InputError that names the mesh: it is not closed
cloud::Shape mesh_shape(cloud::TriangleMesh mesh, const std::string& name);

}  // namespace isotouch::evaluate
