#include "host/cloud/read_cloud.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "host/cloud/file_kind.h"
#include "host/cloud/files.h"
#include "host/cloud/obj.h"
#include "host/cloud/ply.h"
#include "host/cloud/xyz.h"
#include "host/error.h"
#include "shared/hash64.h"

namespace isotouch::cloud {
namespace {

Model read_model(const std::filesystem::path& file, std::span<const std::uint8_t> bytes) {
  const std::string name = file.string();
  switch (file_kind(file, bytes)) {
    case FileKind::kPly: return read_ply(name, bytes);
    case FileKind::kObj: return read_obj_points(name, bytes);
    case FileKind::kText: return read_xyz(name, bytes);
    case FileKind::kStl: throw InputError(name + ": an STL file holds triangles, not points with normals; name a PLY, OBJ or text cloud");
    case FileKind::kUnknown: break;
  }
  throw InputError(name + ": nothing tells what kind of file this is; a cloud ends in .ply, .obj, .xyz, .pwn, .npts or .txt");
}

}  // namespace

OrientedPoints read_cloud(const std::filesystem::path& file, CloudReport& report) {
  const std::vector<std::uint8_t> bytes = read_file(file);
  if (bytes.empty()) throw InputError(file.string() + ": the file is empty");
  report = CloudReport{};
  report.source_hash = hash64(bytes.data(), bytes.size());
  return check(file.string(), read_model(file, bytes), report);
}

}  // namespace isotouch::cloud
