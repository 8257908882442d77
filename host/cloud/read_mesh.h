/// A file → a triangle mesh.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

#include "host/cloud/mesh.h"

namespace isotouch::cloud {

/// What stands in a mesh's file.
struct MeshReport {
  std::string format;             ///< "STL, binary"
  std::uint64_t source_hash = 0;  ///< of the file's bytes, as a blob stores it
};

/// Reads PLY, OBJ or STL (ascii or binary). Vertices at exactly the same place are joined, larger polygons cut into fans, faces that name one
/// place twice and vertices without a face dropped.
///
/// fails     InputError: as the readers; a coordinate beyond 1e12; no faces left
TriangleMesh read_mesh(const std::filesystem::path& file);
TriangleMesh read_mesh(const std::filesystem::path& file, MeshReport& report);

/// Is the file a mesh, when nobody says? STL always is, PLY and OBJ where there are faces and no normals: scans often carry faces too, and the
/// points with their normals are what was measured.
///
/// fails     InputError: the file cannot be read, or not understood so far
bool is_mesh_file(const std::filesystem::path& file);

}  // namespace isotouch::cloud
