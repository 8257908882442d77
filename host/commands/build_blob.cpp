#include "host/commands/build_blob.h"

#include <Eigen/Geometry>
#include <cstdint>
#include <cstdio>
#include <utility>
#include <vector>

#include "host/blob/certificate.h"
#include "host/blob/inside_samples.h"
#include "host/blob/packed.h"
#include "host/cloud/files.h"
#include "host/commands/progress_bar.h"
#include "host/field/build_field.h"
#include "host/field/make_grid.h"
#include "host/field/parallel.h"
#include "host/published/build.h"

namespace isotouch::commands {

namespace {

/// The field of either method, and how many of its samples are inside where the method knows that itself.
struct Made {
  field::BandField field;
  std::optional<std::size_t> inside_nodes;
};

Made make_field(const BuildOptions& options, const cloud::OrientedPoints& points, field::Progress& progress) {
  Eigen::AlignedBox3d box;
  for (const Eigen::Vector3d& position : points.positions) box.extend(position);
  const double edge = options.voxel_mm.value_or(box.sizes().maxCoeff() / options.grid);
  if (options.method == blob::Method::kPublished) {
    const published::Built built = published::build(points, field::make_grid(box.min(), box.max(), edge, published::kMargin), progress);
    return {published::to_band_field(built.levels), built.inside_nodes};
  }
  const double band = options.band_voxels();
  const field::Grid grid = field::make_grid(box.min(), box.max(), edge, field::field_margin(band));
  return {field::build_field(points, grid, band, progress), std::nullopt};
}

}  // namespace

BuiltBlob build_blob(const BuildOptions& options) {
  field::threads_wanted = options.threads;
  BuildReport report;
  field::Progress progress(progress_bar());
  progress.begin("read");
  const cloud::OrientedPoints in_cloud = cloud::read_cloud(options.cloud, report.cloud);
  progress.end();
  for (const std::string& warning : report.cloud.warnings()) {
    std::fprintf(stderr, "isotouch: %s: %s\n", options.cloud.string().c_str(), warning.c_str());
  }
  cloud::PlacementOptions size{std::nullopt, options.fit_mm};
  if (!options.units.empty()) size.mm_per_unit = cloud::mm_per_unit(options.units);
  report.placement = cloud::place(in_cloud, size);
  cloud::OrientedPoints points = cloud::placed(in_cloud, report.placement);
  Made made = make_field(options, points, progress);

  progress.begin("blob");
  const blob::BlobInfo info{options.stiffness, report.cloud.source_hash, options.method, static_cast<std::uint32_t>(in_cloud.size()),
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
  return {std::move(points), std::move(blob), std::move(report)};
}

}  // namespace isotouch::commands
