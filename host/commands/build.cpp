/// isotouch build: oriented points → field → blob.
#include <CLI/CLI.hpp>
#include <Eigen/Geometry>
#include <cstdio>
#include <filesystem>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <utility>

#include "host/blob/inside_samples.h"
#include "host/blob/write_blob.h"
#include "host/cloud/files.h"
#include "host/cloud/placement.h"
#include "host/cloud/read_cloud.h"
#include "host/commands/commands.h"
#include "host/commands/progress_bar.h"
#include "host/commands/quantities.h"
#include "host/evaluate/hash_text.h"
#include "host/evaluate/open_blob.h"
#include "host/field/build_field.h"
#include "host/field/make_grid.h"
#include "host/published/build.h"

namespace isotouch::commands {

namespace {

struct BuildOptions {
  std::filesystem::path cloud;
  std::filesystem::path out;
  blob::Method method = blob::Method::kDefault;
  std::optional<double> voxel_mm;
  int grid = 186;  // voxels along the longest side: the paper's owl
  std::optional<double> band;
  double stiffness = 0.8;
  std::string units;  // empty = fit
  double fit_mm = 70.0;
  bool json = false;

  double band_voxels() const { return band.value_or(4.0); }
};

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

struct BuildReport {
  cloud::CloudReport cloud;
  cloud::Placement placement;
  std::size_t inside_nodes = 0;
  double seconds = 0;
  std::vector<std::pair<std::string, double>> stages;
};

void print_json(const BuildReport& report, const BlobView& view) {
  nlohmann::ordered_json stages = nlohmann::ordered_json::object();
  for (const auto& [stage, seconds] : report.stages) stages[stage] = seconds;
  const nlohmann::ordered_json json = {
      {"points", report.cloud.points}, {"inside_nodes", report.inside_nodes},      {"seconds", report.seconds},          {"stages", stages},
      {"bytes", view.image.size()},    {"hash", evaluate::hash_text(view.hash())}, {"warnings", report.cloud.warnings()}};
  std::printf("%s\n", json.dump(2).c_str());
}

void print_text(const BuildReport& report, const BlobView& view, const std::filesystem::path& out) {
  const auto& [scale, offset] = report.placement;
  const double edge = static_cast<double>(view.edge.raw()) / (1 << MmPerVoxel::kFractionBits);
  std::printf("points        %zu (%s)\n", report.cloud.points, report.cloud.format.c_str());
  std::printf("transform     workspace mm = %.9g · cloud + (%.9g, %.9g, %.9g)\n", scale, offset.x(), offset.y(), offset.z());
  std::printf("grid          %d × %d × %d samples, voxel %.4f mm\n", view.size[0], view.size[1], view.size[2], edge);
  std::printf("inside nodes  %zu\n", report.inside_nodes);
  std::printf("seconds       %.3f:", report.seconds);
  for (const auto& [stage, seconds] : report.stages) std::printf(" %s %.3f", stage.c_str(), seconds);
  std::printf("\nblob          %s, %zu bytes, hash %s\n", out.string().c_str(), view.image.size(),
              evaluate::hash_text(view.hash()).c_str());
}

void run(const BuildOptions& options) {
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
  const Made made = make_field(options, cloud::placed(in_cloud, report.placement), progress);

  progress.begin("blob");
  const blob::BlobInfo info{options.stiffness, report.cloud.source_hash, options.method, static_cast<std::uint32_t>(in_cloud.size()),
                            report.placement};
  const evaluate::OpenBlob blob = evaluate::open_blob(blob::write_blob(made.field, info), options.out.string());
  progress.begin("write");
  cloud::write_file(options.out, blob.image.data(), blob.image.size());
  progress.end();

  report.inside_nodes = made.inside_nodes.value_or(blob::inside_samples(blob.view));
  report.stages = progress.seconds();
  for (const auto& [stage, seconds] : report.stages) report.seconds += seconds;
  if (options.json) {
    print_json(report, blob.view);
  } else {
    print_text(report, blob.view, options.out);
  }
}

}  // namespace

void add_build(CLI::App& app) {
  auto options = std::make_shared<BuildOptions>();
  CLI::App* command = app.add_subcommand("build", "Turn a cloud of oriented points into a field that can be touched");
  command->add_option("CLOUD", options->cloud, "points with normals: PLY, OBJ, or text (.xyz, .pwn, .npts)")->required();
  command->add_option("-o,--out", options->out, "the blob to write (.itf)")->required();
  const std::map<std::string, blob::Method> methods = {{"default", blob::Method::kDefault}, {"published", blob::Method::kPublished}};
  command->add_option("--method", options->method, "default, or published: the paper's levels")
      ->transform(CLI::CheckedTransformer(methods));
  CLI::Option* voxel = command->add_option("--voxel", options->voxel_mm, "edge of a voxel, such as 0.34mm");
  voxel->transform(quantity(kLength, 1.0 / 64, 16));
  CLI::Option* grid =
      command->add_option("--grid", options->grid, "voxels along the longest side of the cloud's box")->capture_default_str();
  grid->check(CLI::Range(8, 4000))->excludes(voxel);
  CLI::Option* band = command->add_option("--band", options->band, "half width of the band, voxels; 4 unless given");
  band->check(CLI::Range(1.0, 7.99));
  command->add_option("--stiffness", options->stiffness, "of the surface, such as 0.8N/mm")
      ->transform(quantity(kStiffness, 0.001, 100))
      ->capture_default_str();
  CLI::Option* fit =
      command->add_option("--fit", options->fit_mm, "scale the longest side to this length, such as 70mm")->capture_default_str();
  fit->transform(quantity(kLength, 1, 1000));
  command->add_option("--units", options->units, "keep the true size: the cloud's unit is mm, cm, m or in")
      ->check(CLI::IsMember({"mm", "cm", "m", "in"}))
      ->excludes(fit);
  command->add_flag("--json", options->json, "print one JSON object");
  command->callback([options] {
    if (options->method == blob::Method::kPublished && options->band) {
      throw CLI::ValidationError("--band", "the published levels have a band of their own, 7 voxels");
    }
    run(*options);
  });
}

}  // namespace isotouch::commands
