/// What `isotouch build` does, for whoever else needs a field of something: input → field → file, with times.
#pragma once

#include <Eigen/Geometry>
#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "host/cloud/oriented_points.h"
#include "host/cloud/placement.h"
#include "host/cloud/source_file.h"
#include "host/encoding/write_image.h"
#include "host/error.h"
#include "host/field/verdict.h"
#include "host/field_file/open_field.h"
#include "host/live/verdict.h"

namespace isotouch::commands {

enum class SourceKind { kCloud, kMesh, kLevelSet };

/// How a field is made. A live field is made of points as a stream makes it (host/live), and is otherwise a field like that of the default method.
enum class BuildMethod { kDefault, kPublished, kLive };

struct BuildOptions {
  std::filesystem::path input;
  std::optional<SourceKind> as = {};  ///< not given: as the file looks
  std::string grid_name = {};         ///< of a level set's file; empty = the first
  std::filesystem::path out;          ///< empty: no file is written
  BuildMethod method = BuildMethod::kDefault;
  Interpolation interpolation = Interpolation::kSpline;
  std::optional<double> voxel_mm = {};
  std::optional<int> grid = {};  ///< voxels along the longest side, without `voxel_mm`; by default host/field/default_grid.h
  std::optional<double> band = {};
  std::optional<Eigen::AlignedBox3d> box = {};  ///< of a live field: the part of the input that it covers; not given: all of it
  std::optional<double> stiffness = {};         ///< the largest, N/mm; 0.8 unless the points have one of their own
  std::string units = {};                       ///< empty = fit
  std::optional<bool> estimate_normals = {};    ///< not given: where the file has none
  cloud::SensorOptions sensor = {};
  bool accept_implausible = false;  ///< write the field although it was judged to be wrong
  double fit_mm = 70.0;
  unsigned threads = 0;  ///< 0 = as many as there are processors
  bool quiet = false;    ///< nothing on standard error; what is doubtful stands in the report alone
  std::function<void(const std::string& stage, double done)> on_progress = {};  ///< at each step: the share of the whole that is done

  double band_voxels() const { return band.value_or(field::kBand); }
};

struct BuildReport {
  SourceKind kind = SourceKind::kCloud;
  std::string format;  ///< "PLY, binary little-endian"
  std::uint64_t source_hash = 0;
  std::size_t points = 0;             ///< of a cloud; vertices of a mesh, active voxels of a level set
  std::vector<std::string> warnings;  ///< one sentence each
  std::size_t closed_faces = 0;       ///< of the file of a cloud, if its faces form a closed surface
  cloud::Placement placement;
  std::size_t inside_nodes = 0;
  std::size_t packed_bytes = 0;  ///< of the file
  double seconds = 0;
  std::vector<std::pair<std::string, double>> stages;
  std::optional<field::Verdict> verdict;      ///< of a cloud
  std::optional<live::Verdict> live_verdict;  ///< of a live field
};

/// The field is probably not that of the scan.
struct Implausible : InputError {
  Implausible(const std::string& input, BuildReport judged);
  BuildReport report;
};

struct BuiltField {
  cloud::OrientedPoints points;                          ///< of a cloud; workspace, mm
  std::vector<std::array<Eigen::Vector3d, 2>> rim = {};  ///< of a cloud: where it ends in the open; workspace, mm
  std::vector<std::array<Eigen::Vector3d, 2>> turned =
      {};  ///< of a cloud: at each point whose normal was turned, two voxels along the normal as it is now
  field_file::OpenField field;
  BuildReport report;
};

/// Reads the input, makes the field and writes its file; shows its progress, and what is doubtful about the input, on standard error.
///
/// fails     InputError of every stage; Implausible, and nothing is written, when the field was judged to be wrong
BuiltField built_field(const BuildOptions& options);

}  // namespace isotouch::commands
