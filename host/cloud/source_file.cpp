#include "host/cloud/source_file.h"

#include <utility>

#include "host/cloud/obj.h"
#include "host/cloud/ply.h"
#include "host/cloud/stl.h"
#include "host/cloud/xyz.h"
#include "host/error.h"
#include "host/files/whole_file.h"
#include "shared/hash64.h"

namespace isotouch::cloud {

SourceFile::SourceFile(std::filesystem::path file) : SourceFile(file, read_file(file)) {}

SourceFile::SourceFile(std::filesystem::path file, std::vector<std::uint8_t> bytes)
    : file_(std::move(file)), bytes_(std::move(bytes)), kind_(file_kind(file_, bytes_)) {
  if (bytes_.empty()) throw InputError(name() + ": the file is empty");
  if (kind_ == FileKind::kPly) ply_ = read_ply_header(name(), bytes_);
}

std::uint64_t SourceFile::hash() const { return hash64(bytes_.data(), bytes_.size()); }

bool SourceFile::is_mesh() const {
  switch (kind_) {
    case FileKind::kStl: return true;
    case FileKind::kPly: return is_bare_ply_mesh(*ply_);
    case FileKind::kObj: return is_bare_obj_mesh(name(), bytes_);
    case FileKind::kText:
    case FileKind::kUnknown: break;
  }
  return false;
}

Model SourceFile::points() const {
  switch (kind_) {
    case FileKind::kPly: return read_ply(name(), bytes_, *ply_);
    case FileKind::kObj: return read_obj_points(name(), bytes_);
    case FileKind::kText: return read_xyz(name(), bytes_);
    case FileKind::kStl: throw InputError(name() + ": an STL file holds triangles, not points with normals; name a PLY, OBJ or text cloud");
    case FileKind::kUnknown: break;
  }
  throw InputError(name() + ": the kind of this file is not recognised; a cloud ends in .ply, .obj, .xyz, .pwn, .npts or .txt");
}

Model SourceFile::faces() const {
  switch (kind_) {
    case FileKind::kPly: return read_ply(name(), bytes_, *ply_);
    case FileKind::kObj: return read_obj_faces(name(), bytes_);
    case FileKind::kStl: return read_stl(name(), bytes_);
    case FileKind::kText:
    case FileKind::kUnknown: break;
  }
  throw InputError(name() + ": this is no kind of mesh file that is known; a mesh ends in .ply, .obj or .stl");
}

}  // namespace isotouch::cloud
