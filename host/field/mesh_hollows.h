/// Which pieces of a mesh are hollows, and whether each of them lies in a body.
#pragma once

#include <cstddef>
#include <string>

#include "host/cloud/mesh.h"
#include "host/field/mesh_repair.h"

namespace isotouch::field {

constexpr double kLeastVolume = 1e-9;  ///< of the cube of a mesh's diagonal: below it is rounding

/// In front of the faces of a sheet that faces inward lies what the sheet encloses. In a hollow nothing winds round that place. An open sheet
/// encloses nothing by itself: it faces inward if that is so in front of the larger part of it. Where hollows overlap, a place counts less than
/// nothing, as it does beside all bodies. Hollows may overlap; but what lies wholly in others may as well be a body, and no body may lie there.
///
/// first_fan   the faces from this one on close holes
/// name        of the file, for the sentences
/// size        the diagonal of the mesh's box
/// repair      takes what was swallowed; names the rims that were closed, and whether all faces were turned
/// fails       InputError with the place, see closed_mesh.h
void require_hollows(const cloud::TriangleMesh& mesh, const std::string& name, double size, std::size_t first_fan, MeshRepair& repair);

}  // namespace isotouch::field
