/// A triangle mesh → the bytes of a file that other programs read: positions and faces, without normals.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "host/cloud/mesh.h"

namespace isotouch::cloud {

/// Binary little-endian PLY with double coordinates.
///
/// comment   one line
std::vector<std::uint8_t> ply_bytes(const TriangleMesh& mesh, const std::string& comment);

/// Wavefront OBJ.
///
/// comment      one line
/// resolution   the coordinates get as many decimal places as tell this length
std::vector<std::uint8_t> obj_bytes(const TriangleMesh& mesh, const std::string& comment, double resolution);

/// Binary STL. Its coordinates have 24 bits: far from the origin they are coarse.
///
/// name         of the file, for the sentence
/// comment      its first 79 characters are kept
/// resolution   what the coordinates must tell at least
/// fails        InputError when they do not
std::vector<std::uint8_t> stl_bytes(const TriangleMesh& mesh, const std::string& name, const std::string& comment, double resolution);

}  // namespace isotouch::cloud
