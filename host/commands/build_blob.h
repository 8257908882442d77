/// What `isotouch build` does, for whoever else needs a blob of a cloud: points → field → blob, with times.
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "host/blob/write_blob.h"
#include "host/cloud/oriented_points.h"
#include "host/cloud/placement.h"
#include "host/cloud/read_cloud.h"
#include "host/evaluate/open_blob.h"

namespace isotouch::commands {

struct BuildOptions {
  std::filesystem::path cloud;
  std::filesystem::path out;
  blob::Method method = blob::Method::kDefault;
  std::optional<double> voxel_mm = {};
  int grid = 186;  ///< voxels along the longest side, without `voxel_mm`: the paper's owl
  std::optional<double> band = {};
  double stiffness = 0.8;
  std::string units = {};  ///< empty = fit
  double fit_mm = 70.0;
  unsigned threads = 0;  ///< 0 = as many as there are processors

  double band_voxels() const { return band.value_or(4.0); }
};

struct BuildReport {
  cloud::CloudReport cloud;
  cloud::Placement placement;
  std::size_t inside_nodes = 0;
  double seconds = 0;
  std::vector<std::pair<std::string, double>> stages;
};

struct BuiltBlob {
  cloud::OrientedPoints points;  ///< workspace, mm
  evaluate::OpenBlob blob;
  BuildReport report;
};

/// Reads the cloud, makes the field and writes the blob; shows its progress, and what is doubtful about the cloud, on standard error.
///
/// fails     InputError of every stage
BuiltBlob build_blob(const BuildOptions& options);

}  // namespace isotouch::commands
