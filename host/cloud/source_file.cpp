#include "host/cloud/source_file.h"

#include <utility>

#include "host/cloud/obj.h"
#include "host/cloud/pcd.h"
#include "host/cloud/ply.h"
#include "host/cloud/stl.h"
#include "host/cloud/xyz.h"
#include "host/files/file_nature.h"
#include "host/files/whole_file.h"
#include "shared/hash64.h"

namespace isotouch::cloud {
namespace {

/// Where an image was not seen from the place that the file states or its format suggests, its points may be in the camera's own frame.
void take_normals_of(ScanGrid grid, Model& model) {
  model.edges = orient_by_grid(model, grid, &model.sensor.is_elsewhere);
  if (!model.edges && (grid.known == ScanGrid::Known::kStated || grid.known == ScanGrid::Known::kUsual)) {
    const bool is_refuted = model.sensor.is_elsewhere;
    grid.sensor.setZero();
    grid.known = ScanGrid::Known::kAssumed;
    model.edges = orient_by_grid(model, grid, &model.sensor.is_elsewhere);
    if (model.edges || is_refuted) model.sensor.refuted_place = std::exchange(model.sensor.place, std::nullopt);
  }
  if (!model.edges) return;
  model.sensor.place = grid.sensor;
  model.sensor.is_assumed = grid.known == ScanGrid::Known::kUsual || grid.known == ScanGrid::Known::kAssumed;
}

}  // namespace

SourceFile::SourceFile(std::filesystem::path file, SensorOptions sensor) : SourceFile(file, read_file(file), std::move(sensor)) {}

SourceFile::SourceFile(std::filesystem::path file, std::vector<std::uint8_t> bytes, SensorOptions sensor)
    : file_(std::move(file)), bytes_(std::move(bytes)), kind_(file_kind(file_, bytes_)), sensor_(std::move(sensor)) {
  if (bytes_.empty()) throw InputError(name() + ": the file is empty; export or copy it again");
  refuse_what_is_ours();
  if (sensor_.camera && kind_ != FileKind::kDepthImage)
    throw UsageError(name() + ": --intrinsics describes the camera of a depth image (PNG), this is none; leave it out");
  if (kind_ == FileKind::kPly) ply_ = read_ply_header(name(), bytes_);
}

void SourceFile::refuse_what_is_ours() const {
  switch (nature_of(bytes_)) {
    case FileNature::kField: throw InputError(name() + ": is a field already; name the scan or the mesh");
    case FileNature::kPatches: throw InputError(name() + ": holds patches of a field; name the scan or the mesh");
    case FileNature::kTrace: throw InputError(name() + ": is a trace; make points of what a hand felt with isotouch scan");
    case FileNature::kPointer: throw InputError(name() + kIsPointer);
    case FileNature::kUnknown: break;
  }
}

std::uint64_t SourceFile::hash() const { return hash64(bytes_.data(), bytes_.size()); }

bool SourceFile::is_mesh() const {
  switch (kind_) {
    case FileKind::kStl: return true;
    case FileKind::kPly: return is_bare_ply_mesh(*ply_);
    case FileKind::kObj: return is_bare_obj_mesh(name(), bytes_);
    case FileKind::kText:
    case FileKind::kPcd:
    case FileKind::kDepthImage:
    case FileKind::kLaserScan:
    case FileKind::kUnknown: break;
  }
  return false;
}

Model SourceFile::points() const {
  Model model = read_points();
  place_sensor(model);
  if (model.grid && model.normals.empty()) take_normals_of(std::move(*model.grid), model);
  model.grid.reset();
  return model;
}

/// Where a person says that the sensor stood, or did not.
void SourceFile::place_sensor(Model& model) const {
  if (sensor_.ignores_viewpoint) {
    model.sensor.place.reset();
    if (model.grid) model.grid->sensor.setZero();
  } else if (sensor_.viewpoint) {
    if (model.grid) model.grid->sensor = *sensor_.viewpoint;
  } else {
    return;
  }
  if (model.grid) model.grid->known = sensor_.ignores_viewpoint ? ScanGrid::Known::kAssumed : ScanGrid::Known::kSurely;
}

Model SourceFile::read_points() const {
  switch (kind_) {
    case FileKind::kPly: {
      Model model = read_ply(name(), bytes_, *ply_);
      for (const PlyElement& element : ply_->elements) {
        if (element.name == "face") model.unused_faces = model.faces.empty() ? 0 : element.count;
      }
      return model;
    }
    case FileKind::kObj: return read_obj_points(name(), bytes_);
    case FileKind::kText: return read_xyz(name(), bytes_);
    case FileKind::kPcd: return read_pcd(name(), bytes_);
    case FileKind::kDepthImage:
      if (!sensor_.camera) throw InputError(name() + ": a depth image needs its camera: give --intrinsics FX,FY,CX,CY, in pixels");
      return read_depth_image(name(), bytes_, *sensor_.camera);
    case FileKind::kStl:
      throw InputError(name() + ": an STL file holds triangles, not points with normals; name a PLY, OBJ, PCD or text cloud");
    case FileKind::kLaserScan:
    case FileKind::kUnknown: break;
  }
  throw not_read("the kind of this file is not recognised; a cloud ends in .ply, .obj, .pcd, .png or, as text, in " +
                 endings_of(FileKind::kText));
}

Model SourceFile::faces() const {
  switch (kind_) {
    case FileKind::kPly:
      for (const PlyElement& element : ply_->elements) {
        if (is_strips(element))
          throw InputError(name() +
                           ": its faces are strips of triangles (element 'tristrips'), which are not read; save the mesh with faces");
      }
      return read_ply(name(), bytes_, *ply_);
    case FileKind::kObj: return read_obj_faces(name(), bytes_);
    case FileKind::kStl: return read_stl(name(), bytes_);
    case FileKind::kText:
    case FileKind::kPcd:
    case FileKind::kDepthImage:
    case FileKind::kLaserScan:
    case FileKind::kUnknown: break;
  }
  throw not_read("this is no kind of mesh file that is known; a mesh ends in .ply, .obj or .stl");
}

InputError SourceFile::not_read(const std::string& otherwise) const {
  if (kind_ != FileKind::kLaserScan) return InputError(name() + ": " + otherwise);
  return InputError(
      name() + ": E57, LAS and LAZ files, which laser scanners write, are not read; open it in CloudCompare and save it as PLY or PCD");
}

}  // namespace isotouch::cloud
