#include "host/commands/build_blob.h"

#include <Eigen/Geometry>
#include <cstdint>
#include <cstdio>
#include <span>
#include <utility>
#include <vector>

#include "host/blob/certificate.h"
#include "host/blob/inside_samples.h"
#include "host/blob/packed.h"
#include "host/cloud/files.h"
#include "host/cloud/mesh.h"
#include "host/cloud/read_cloud.h"
#include "host/cloud/read_mesh.h"
#include "host/commands/progress_bar.h"
#include "host/error.h"
#include "host/field/build_field.h"
#include "host/field/closed_mesh.h"
#include "host/field/make_grid.h"
#include "host/field/mesh_distance.h"
#include "host/field/mesh_field.h"
#include "host/field/parallel.h"
#include "host/published/build.h"

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
  return field::make_grid(box.min(), box.max(), options.voxel_mm.value_or(box.sizes().maxCoeff() / options.grid), margin);
}

Made from_cloud(const BuildOptions& options, BuildReport& report, field::Progress& progress) {
  progress.begin("read");
  cloud::CloudReport read;
  const cloud::OrientedPoints in_cloud = cloud::read_cloud(options.input, read);
  progress.end();
  report.placement = placement(options, in_cloud.positions);
  report.format = read.format;
  report.source_hash = read.source_hash;
  report.points = in_cloud.size();
  report.spacing = report.placement.scale * read.median_spacing;
  report.warnings = read.warnings();
  cloud::OrientedPoints points = cloud::placed(in_cloud, report.placement);

  if (options.method == blob::Method::kPublished) {
    const published::Built built = published::build(points, grid_round(options, points.positions, published::kMargin), progress);
    return {published::to_band_field(built.levels), built.inside_nodes, std::move(points)};
  }
  const double band = options.band_voxels();
  const field::Grid grid = grid_round(options, points.positions, field::field_margin(band));
  return {field::build_field(points, grid, band, progress), std::nullopt, std::move(points)};
}

Made from_mesh(const BuildOptions& options, BuildReport& report, field::Progress& progress) {
  if (options.method == blob::Method::kPublished) {
    throw InputError(options.input.string() + ": the published method works on points with normals, this is a mesh; leave --method out");
  }
  progress.begin("read");
  cloud::MeshReport read;
  const cloud::TriangleMesh file = cloud::read_mesh(options.input, read);
  progress.begin("check");
  field::MeshRepair repair;
  const cloud::TriangleMesh in_file = field::closed_mesh(file, options.input.string(), repair);
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

}  // namespace

BuiltBlob build_blob(const BuildOptions& options) {
  field::threads_wanted = options.threads;
  BuildReport report;
  field::Progress progress(progress_bar());
  report.kind = options.as.value_or(cloud::is_mesh_file(options.input) ? InputKind::kMesh : InputKind::kCloud);
  Made made = report.kind == InputKind::kMesh ? from_mesh(options, report, progress) : from_cloud(options, report, progress);
  for (const std::string& warning : report.warnings)
    std::fprintf(stderr, "isotouch: %s: %s\n", options.input.string().c_str(), warning.c_str());

  progress.begin("blob");
  const blob::BlobInfo info{options.stiffness, report.source_hash, options.method, static_cast<std::uint32_t>(report.points),
                            report.placement};
  evaluate::OpenBlob blob = evaluate::open_blob(blob::write_blob(std::move(made.field), info), options.out.string());
  progress.begin("pack");
  const std::vector<std::uint8_t> packed = blob::pack(blob.view);
  const double advised = blob::certificate_of(blob.view).stiffness_n_per_mm;
  if (options.stiffness > advised) {
    std::fprintf(
        stderr,
        "isotouch: a stiffness of %g N/mm may feed energy into the hand; up to %.3g N/mm is safe with the device that `info` assumes\n",
        options.stiffness, advised);
  }
  progress.begin("write");
  cloud::write_file(options.out, packed.data(), packed.size());
  progress.end();

  report.inside_nodes = made.inside_nodes.value_or(blob::inside_samples(blob.view));
  report.stages = progress.seconds();
  for (const auto& [stage, seconds] : report.stages) report.seconds += seconds;
  return {std::move(made.points), std::move(blob), std::move(report)};
}

}  // namespace isotouch::commands
