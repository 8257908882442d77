/// A file of points or faces, read once and understood once.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "host/cloud/depth_image.h"
#include "host/cloud/file_kind.h"
#include "host/cloud/model.h"
#include "host/cloud/ply_header.h"
#include "host/error.h"

namespace isotouch::cloud {

/// What is known of the sensor and does not stand in the file.
struct SensorOptions {
  std::optional<DepthCamera> camera = {};         ///< of a depth image
  std::optional<Eigen::Vector3d> viewpoint = {};  ///< the sensor's place in the file's frame, instead of the file's own
  bool ignores_viewpoint = false;                 ///< what the file says of the sensor's place is left out
};

class SourceFile {
 public:
  /// fails     InputError naming the file: it cannot be read, is empty, is a field or a trace, or begins with a PLY header that is none; UsageError: a
  ///           camera for something else than a depth image
  SourceFile(std::filesystem::path file, SensorOptions sensor = {});  // NOLINT(google-explicit-constructor): a path names its file

  /// What was read already.
  SourceFile(std::filesystem::path file, std::vector<std::uint8_t> bytes, SensorOptions sensor = {});

  std::string name() const { return file_.string(); }
  /// Of the file's bytes, as a field stores it.
  std::uint64_t hash() const;

  /// Is the file a mesh, when nobody says? STL always is; PLY and OBJ are where there are faces and no normals. Scans often carry faces, too, and then the
  /// points with their normals are what was measured.
  bool is_mesh() const;

  /// The points; those of a grid with the grid's normals (scan_grid.h) where the file has none.
  ///
  /// fails     InputError: as the reader of the file's kind; a kind that holds no points, a depth image without a camera
  Model points() const;
  /// fails     InputError: as the reader of the file's kind; no kind of mesh file that is known
  Model faces() const;

 private:
  std::filesystem::path file_;
  std::vector<std::uint8_t> bytes_;
  FileKind kind_;
  std::optional<PlyHeader> ply_;  ///< of a PLY file
  SensorOptions sensor_;

  Model read_points() const;
  void place_sensor(Model& model) const;
  void refuse_what_is_ours() const;
  InputError not_read(const std::string& otherwise) const;
};

}  // namespace isotouch::cloud
