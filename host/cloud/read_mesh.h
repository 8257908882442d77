/// A file → a triangle mesh.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

#include "host/cloud/mesh.h"
#include "host/cloud/source_file.h"
#include "host/error.h"

namespace isotouch::cloud {

/// A file of points without faces.
class NoFaces : public InputError {
 public:
  /// remedy    what to do about it
  NoFaces(const std::string& file, const std::string& remedy) : InputError(file + ": has points and no faces; " + remedy) {}
};

/// What stands in a mesh's file.
struct MeshReport {
  std::string format;             ///< "STL, binary"
  std::uint64_t source_hash = 0;  ///< of the file's bytes, as an image stores it
};

/// Reads PLY, OBJ or STL (ascii or binary). Vertices at exactly the same place are joined, larger polygons cut into triangles, faces that name one
/// place twice and vertices without a face dropped.
///
/// fails     InputError: as the readers and `cut_polygons`; a coordinate beyond 1e12; no faces left, as NoFaces where the file has none
TriangleMesh read_mesh(const std::filesystem::path& file);
TriangleMesh read_mesh(const SourceFile& file, MeshReport& report);

}  // namespace isotouch::cloud
