#include "host/commands/built_field.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <span>
#include <utility>
#include <vector>

#include "host/cloud/mesh.h"
#include "host/cloud/read_cloud.h"
#include "host/cloud/read_mesh.h"
#include "host/commands/progress_bar.h"
#include "host/encoding/certificate.h"
#include "host/encoding/inside_samples.h"
#include "host/error.h"
#include "host/field/brick_stiffness.h"
#include "host/field/build_field.h"
#include "host/field/closed_mesh.h"
#include "host/field/make_grid.h"
#include "host/field/mesh_distance.h"
#include "host/field/mesh_field.h"
#include "host/field/nearest.h"
#include "host/field/parallel.h"
#include "host/field_file/packed.h"
#include "host/files/whole_file.h"
#include "host/published/build.h"
#include "host/vdb/level_set.h"
#include "host/vdb/level_set_field.h"

namespace isotouch::commands {

namespace {

/// A field, and what only its maker knows.
struct Made {
  field::BandField field;
  std::optional<std::size_t> inside_nodes = {};
  cloud::OrientedPoints points = {};
};

cloud::Placement placement(const BuildOptions& options, std::span<const Eigen::Vector3d> positions) {
  cloud::PlacementOptions size{std::nullopt, options.fit_mm};
  if (!options.units.empty()) size.mm_per_unit = cloud::mm_per_unit(options.units);
  return cloud::place(positions, size);
}

/// The grid round placed positions.
field::Grid grid_round(const BuildOptions& options, std::span<const Eigen::Vector3d> positions, double margin) {
  Eigen::AlignedBox3d box;
  for (const Eigen::Vector3d& position : positions) box.extend(position);
  return field::make_grid(box.min(), box.max(), options.voxel_mm.value_or(box.sizes().maxCoeff() / options.grid_voxels()), margin);
}

/// fails     InputError when the published method was asked for something else than points
void require_default_method(const BuildOptions& options, const char* what) {
  if (options.method == encoding::Method::kPublished) {
    throw InputError(options.input.string() + ": the published method works on points with normals, this is " + what +
                     "; leave --method out");
  }
}

Made from_cloud(const cloud::SourceFile& source, const BuildOptions& options, BuildReport& report, field::Progress& progress) {
  cloud::CloudReport read;
  const cloud::OrientedPoints in_cloud = cloud::read_cloud(source, read);
  progress.end();
  report.placement = placement(options, in_cloud.positions);
  report.format = read.format;
  report.source_hash = read.source_hash;
  report.points = in_cloud.size();
  report.warnings = read.warnings();
  cloud::OrientedPoints points = cloud::placed(in_cloud, report.placement);

  if (options.method == encoding::Method::kPublished) {
    const published::Built built = published::build(points, grid_round(options, points.positions, published::kMargin), progress);
    Made made{published::to_band_field(built.levels), built.inside_nodes, std::move(points)};
    if (!made.points.stiffness.empty()) {
      std::vector<Eigen::Vector3d> places;
      for (const Eigen::Vector3d& p : made.points.positions) places.push_back(made.field.grid.to_index(p));
      made.field.stiffness = field::brick_stiffness(made.field.bricks, made.points.stiffness, field::Nearest(places));
    }
    return made;
  }
  const double band = options.band_voxels();
  const field::Grid grid = grid_round(options, points.positions, field::field_margin(band));
  field::Repair repair;
  Made made{field::build_field(points, grid, band, progress, &repair), std::nullopt, {}};
  for (const std::string& warning : repair.warnings()) report.warnings.push_back(warning);
  made.points = std::move(points);
  return made;
}

Made from_mesh(const cloud::SourceFile& source, const BuildOptions& options, BuildReport& report, field::Progress& progress) {
  require_default_method(options, "a mesh");
  cloud::MeshReport read;
  const cloud::TriangleMesh file = cloud::read_mesh(source, read);
  progress.begin("check");
  field::MeshRepair repair;
  const cloud::TriangleMesh in_file = field::closed_mesh(file, options.input.string(), repair);
  if (!options.as && repair.holes > 0 && !read.format.starts_with("STL")) {  // more likely a scan with some faces than a body
    throw InputError(
        options.input.string() + ": its " + std::to_string(file.vertices.size()) +
        " points have no normals, and its faces do not close; estimate outward normals in a point-cloud program and save them with "
        "the points, or say --as mesh to have the holes closed");
  }
  report.placement = placement(options, in_file.vertices);
  report.format = read.format;
  report.source_hash = read.source_hash;
  report.points = file.vertices.size();

  progress.begin("tree");
  const field::MeshDistance distance(cloud::placed(in_file, report.placement));
  repair.crossing = distance.crossings().faces;
  repair.cross = report.placement.to_cloud(distance.crossings().first);
  report.warnings = repair.warnings();
  progress.begin("bricks");
  const double band = options.band_voxels();
  Made made{field::mesh_field(distance, grid_round(options, distance.mesh().vertices, field::mesh_margin(band)), band)};
  progress.end();
  return made;
}

/// The band that a level set is known in: as asked for, or the usual one where there are as many.
double band_within(const BuildOptions& options, double known) {
  known = std::min(known, 7.99);
  if (known < 1.0 || options.band.value_or(1.0) > known) {
    throw InputError(options.input.string() + ": the level set is known " + std::to_string(known) +
                     " of these voxels to each side of its surface, " + (known < 1.0 ? "at least 1 is" : "more are") +
                     " needed; choose a smaller --band or --voxel, or make its band wider");
  }
  return options.band.value_or(std::min(field::kBand, known));
}

Made from_level_set(const BuildOptions& options, BuildReport& report, field::Progress& progress) {
  require_default_method(options, "a level set");
  progress.begin("read");
  const vdb::LevelSet set = vdb::LevelSet::read(options.input, options.grid_name);
  report.placement = placement(options, set.crossings);
  report.format = set.format;
  report.source_hash = set.source_hash;
  report.points = set.active_voxels;
  report.warnings = set.warnings;
  progress.begin("bricks");
  Made made;
  if (set.samples && !options.voxel_mm && !options.grid) {
    made.field = vdb::own_field(set, report.placement, band_within(options, set.half_width));
  } else {
    BuildOptions own = options;  // turned axes alone: voxels of the same size
    if (!options.voxel_mm && !options.grid) own.voxel_mm = report.placement.scale * set.edge;
    std::vector<Eigen::Vector3d> surface = set.crossings;
    for (Eigen::Vector3d& place : surface) place = report.placement.to_workspace(place);
    const vdb::Interpolation interpolation(set);
    field::Grid grid = grid_round(own, surface, 0);
    const double band = band_within(options, vdb::known_band(interpolation, set, report.placement, grid.edge));
    grid = grid_round(own, surface, field::mesh_margin(band));
    made.field = vdb::resampled_field(interpolation, set, report.placement, grid, band);
  }
  progress.end();
  return made;
}

/// The file's field; what kind of file it is enters the report.
Made make_field(const BuildOptions& options, BuildReport& report, field::Progress& progress) {
  const bool is_level_set = options.as ? *options.as == InputKind::kLevelSet : vdb::is_vdb_file(options.input);
  report.kind = InputKind::kLevelSet;
  if (is_level_set) return from_level_set(options, report, progress);
  if (!options.grid_name.empty()) {
    throw InputError(options.input.string() + ": --grid-name names a grid of an OpenVDB file, this is none; leave it out");
  }
  progress.begin("read");
  const cloud::SourceFile source(options.input);
  report.kind = options.as ? *options.as : source.is_mesh() ? InputKind::kMesh : InputKind::kCloud;
  return report.kind == InputKind::kMesh ? from_mesh(source, options, report, progress) : from_cloud(source, options, report, progress);
}

}  // namespace

BuiltField built_field(const BuildOptions& options) {
  field::threads_wanted = options.threads;
  BuildReport report;
  field::Progress progress(options.quiet ? field::Progress::Show{} : progress_bar());
  Made made = make_field(options, report, progress);
  if (!options.quiet) {
    for (const std::string& warning : report.warnings)
      std::fprintf(stderr, "isotouch: %s: %s\n", options.input.string().c_str(), warning.c_str());
  }

  progress.begin("blob");
  const std::vector<double>& stiffness = made.field.stiffness;
  const double own = stiffness.empty() ? 0.8 : *std::max_element(stiffness.begin(), stiffness.end());
  const encoding::FieldInfo info{options.stiffness.value_or(own), report.source_hash, options.method,
                                 static_cast<std::uint32_t>(report.points), report.placement};
  field_file::OpenField field = field_file::open_field(encoding::write_image(std::move(made.field), info), options.out.string());
  progress.begin("pack");
  const std::vector<std::uint8_t> packed = field_file::pack(field.view);
  const double advised = encoding::certificate_of(field.view).stiffness_n_per_mm;
  if (info.stiffness_n_per_mm > advised && !options.quiet) {
    std::fprintf(
        stderr,
        "isotouch: a stiffness of %g N/mm may feed energy into the hand; up to %.3g N/mm is safe with the device that `info` assumes\n",
        info.stiffness_n_per_mm, advised);
  }
  progress.begin("write");
  write_file(options.out, packed.data(), packed.size());
  progress.end();

  report.inside_nodes = made.inside_nodes.value_or(encoding::inside_samples(field.view));
  report.packed_bytes = packed.size();
  report.stages = progress.seconds();
  for (const auto& [stage, seconds] : report.stages) report.seconds += seconds;
  return {std::move(made.points), std::move(field), std::move(report)};
}

}  // namespace isotouch::commands
