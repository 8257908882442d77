/// A file of points or faces, read once and understood once.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "host/cloud/file_kind.h"
#include "host/cloud/model.h"
#include "host/cloud/ply_header.h"

namespace isotouch::cloud {

class SourceFile {
 public:
  /// fails     InputError naming the file: it cannot be read, is empty, or begins with a PLY header that is none
  SourceFile(std::filesystem::path file);  // NOLINT(google-explicit-constructor): a path names its file

  /// What was read already.
  SourceFile(std::filesystem::path file, std::vector<std::uint8_t> bytes);

  std::string name() const { return file_.string(); }
  /// Of the file's bytes, as a field stores it.
  std::uint64_t hash() const;

  /// Is the file a mesh, when nobody says? STL always is; PLY and OBJ are where there are faces and no normals. Scans often carry faces, too, and then the
  /// points with their normals are what was measured.
  bool is_mesh() const;

  /// fails     InputError: as the reader of the file's kind; a file that holds no points with normals
  Model points() const;
  /// fails     InputError: as the reader of the file's kind; no kind of mesh file that is known
  Model faces() const;

 private:
  std::filesystem::path file_;
  std::vector<std::uint8_t> bytes_;
  FileKind kind_;
  std::optional<PlyHeader> ply_;  ///< of a PLY file
};

}  // namespace isotouch::cloud
