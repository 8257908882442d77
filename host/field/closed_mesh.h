/// What a mesh must be before its distances are asked for, and what is put right on the way.
#pragma once

#include <string>

#include "host/cloud/mesh.h"
#include "host/field/mesh_repair.h"

namespace isotouch::field {

/// Checks and mends, in this order:
///
/// repeated    where the edges are not run as often in one direction as in the other, faces that are written twice are dropped
/// direction   two faces that share an edge must run it in opposite directions
/// holes       every rim gets a fan round the mean of its edges. Then each edge is run as often in one direction as in the other, and winding
///             numbers are whole
/// inside out  a mesh of negative volume is turned round. Pieces are not turned one by one: a piece that faces inward is a hollow when all of
///             it lies in others. Each of its faces is asked at its middle and at its corners. A piece that is closed only together with others
///             (sheets.h) is asked whichever way it faces, and faces inward if most of its area does; tiny ones may face as they will.
///             Hollows may overlap; but one that lies wholly in others may as well be a body, and a body where they overlap would be lost
///
/// swallowed   closed pieces that face outward and lie in others are counted: their union with these has no trace of them
///
/// name        of the file, for the sentences
/// fails       InputError with the place: hardly any faces share their corners, although these lie side by side; faces turn against each other; nothing
///             is enclosed; a piece, or a part of it, faces inward beside the others, or outward where most face inward; a hollow lies in another one,
///             or a body where hollows overlap. Of a piece with fans it says that the mesh is open
cloud::TriangleMesh closed_mesh(cloud::TriangleMesh mesh, const std::string& name, MeshRepair& repair);

}  // namespace isotouch::field
