/// isotouch build: oriented points, a mesh or a level set → field → file.
#include <CLI/CLI.hpp>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "host/board_commands/choice.h"
#include "host/board_commands/number_in.h"
#include "host/board_commands/output.h"
#include "host/board_commands/print_json.h"
#include "host/cloud/file_kind.h"
#include "host/commands/box_option.h"
#include "host/commands/build_json.h"
#include "host/commands/built_field.h"
#include "host/commands/camera_options.h"
#include "host/commands/commands.h"
#include "host/commands/quantities.h"
#include "host/commands/verdict_text.h"
#include "host/encoding/dense_bytes.h"
#include "host/trace/hash_text.h"

namespace isotouch::commands {

namespace {

void print_text(const BuildReport& report, const FieldView& view, const std::filesystem::path& out) {
  std::FILE* to = text_stream(out);
  const auto& [scale, offset] = report.placement;
  const double edge = static_cast<double>(view.edge.raw()) / (1 << MmPerVoxel::kFractionBits);
  std::fprintf(to, "%-13s %zu (%s)\n", names_of(report.kind).items, report.points, report.format.c_str());
  std::fprintf(to, "transform     workspace mm = %.9g · input + (%.9g, %.9g, %.9g)\n", scale, offset.x(), offset.y(), offset.z());
  std::fprintf(to, "grid          %d × %d × %d samples, voxel %.4f mm\n", view.size[0], view.size[1], view.size[2], edge);
  std::fprintf(to, "inside        %zu grid samples\n", report.inside_nodes);
  if (report.verdict) std::fprintf(to, "verdict       %s\n", in_words(*report.verdict).c_str());
  if (report.live_verdict) std::fprintf(to, "verdict       %s\n", in_words(*report.live_verdict).c_str());
  std::fprintf(to, "seconds       %.3f:", report.seconds);
  for (const auto& [stage, seconds] : report.stages) std::fprintf(to, " %s %.3f", stage.c_str(), seconds);
  std::fprintf(to, "\nfield          %s, hash %s\n", out.string().c_str(), trace::hash_text(view.hash()).c_str());
  std::fprintf(to, "bytes         %zu in memory, %zu packed in the file and for upload; a dense grid of 32-bit floats would take %ju\n",
               view.image.size(), report.packed_bytes, std::uintmax_t{encoding::dense_float_bytes(view)});
}

}  // namespace

void add_build(CLI::App& app) {
  auto options = std::make_shared<BuildOptions>();
  auto json = std::make_shared<bool>(false);
  CLI::App* command = app.add_subcommand("build", "Turn oriented points, a mesh or a level set into a field that can be touched");
  command
      ->add_option("INPUT", options->input,
                   "points with or without normals: PLY, OBJ, PCD, or text (" + cloud::endings_of(cloud::FileKind::kText) +
                       "); a depth image: 16-bit PNG; a mesh: PLY, OBJ, STL; or an OpenVDB level set")
      ->required();
  const std::map<std::string, SourceKind> kinds = {{"cloud", SourceKind::kCloud}, {"mesh", SourceKind::kMesh}};
  command
      ->add_option("--as", options->as,
                   "what INPUT is. By default a file with faces and without normals is a mesh, and a file with normals is a cloud, whose "
                   "faces are ignored")
      ->transform(one_of(kinds));
  add_output(*command, "-o,--out", options->out, {&forms::kField}, "the field file to write",
             "build it first, then write other forms with `isotouch export`")
      ->required();
  const std::map<std::string, BuildMethod> methods = {
      {"default", BuildMethod::kDefault}, {"published", BuildMethod::kPublished}, {"live", BuildMethod::kLive}};
  command
      ->add_option("--method", options->method,
                   "'published' builds integer levels, which are felt as the paper describes; 'live' builds what a stream of the same "
                   "points leads to")
      ->transform(one_of(methods));
  const std::map<std::string, Interpolation> interpolations = {{"spline", Interpolation::kSpline},
                                                               {"trilinear", Interpolation::kTrilinear}};
  const CLI::Option* interpolation =
      command
          ->add_option(
              "--interpolation", options->interpolation,
              "what the field is between its samples: 'spline', a quadratic B-spline, or 'trilinear', as the paper does; by default "
              "'spline'")
          ->transform(one_of(interpolations));
  command->add_option("--grid-name", options->grid_name, "which grid of an OpenVDB file to read; by default its first level set");
  CLI::Option* voxel = command->add_option("--voxel", options->voxel_mm, "edge of a voxel, such as 0.5mm");
  voxel->transform(quantity(kLength, 1.0 / 64, 16));
  CLI::Option* grid = command->add_option(
      "--grid", options->grid,
      "voxels along the longest side of the input's bounding box; by default up to 372 for a mesh, 186 to 372 for points, by how "
      "close together they are, or a level set's own voxels");
  grid->check(whole_number_in(8, 4000))->excludes(voxel);
  CLI::Option* band =
      command->add_option("--band", options->band, "half width of the band around the surface that is stored, in voxels; by default 3");
  band->check(number_in(1.0, 7.99));
  command
      ->add_option("--stiffness", options->stiffness,
                   "stiffness of the surface; by default 0.8N/mm. If the points have stiffness values of their own, this is the largest")
      ->transform(quantity(kStiffness, 0.001, 100));
  CLI::Option* fit =
      command->add_option("--fit", options->fit_mm, "scale the longest side to this length, such as 70mm")->capture_default_str();
  fit->transform(quantity(kLength, 1, 1000));
  command->add_option("--units", options->units, "keep the true size; the unit of the input's coordinates")
      ->check(one_of({"mm", "cm", "m", "in"}))
      ->excludes(fit);
  command
      ->add_option("--threads", options->threads, "number of threads; by default one for each processor. The result does not depend on it")
      ->check(whole_number_in(1, 1024));
  const std::map<std::string, bool> normals = {{"file", false}, {"estimate", true}};
  command
      ->add_option("--normals", options->estimate_normals,
                   "'file' takes the normals of the points, 'estimate' finds them from the points; by default they are estimated where the "
                   "file has none")
      ->transform(one_of(normals));
  add_viewpoint(*command, options->sensor,
                "the sensor's place in the file's coordinates: every normal is turned towards it. By default what the file itself says, "
                "where normals are missing");
  auto camera = std::make_shared<CameraOptions>();
  camera->add_to(*command);
  add_box(*command, options->box,
          "with --method live: the part of space that the field covers, two corners in the file's coordinates; points outside "
          "are left out");
  command->add_flag("--accept-implausible", options->accept_implausible,
                    "write the field although it was judged to be probably wrong; a mesh and a level set are not judged");
  command->add_flag("--json", *json, "print one JSON object");
  command->callback([options, camera, json, interpolation] {
    options->sensor.camera = camera->camera();
    if (options->method == BuildMethod::kPublished && options->band) {
      throw CLI::ValidationError("--band", "the published levels have a band of their own, 7 voxels");
    }
    if (options->method == BuildMethod::kPublished && interpolation->count() > 0 && options->interpolation == Interpolation::kSpline) {
      throw CLI::ValidationError("--interpolation", "the published levels are trilinear");
    }
    if (options->method == BuildMethod::kLive && interpolation->count() > 0 && options->interpolation == Interpolation::kSpline) {
      throw CLI::ValidationError("--interpolation", "a live field is trilinear");
    }
    if (options->box && options->method != BuildMethod::kLive) throw CLI::ValidationError("--box", "only --method live takes a part");
    require_apart(options->out, *json);
    const BuiltField built = [&] {
      try {
        return built_field(*options);
      } catch (const Implausible& refused) {
        if (*json) print_json(refused_json(refused.report));
        throw;
      }
    }();
    if (*json) {
      print_json(to_json(built.report, built.field.view));
    } else {
      print_text(built.report, built.field.view, options->out);
    }
  });
}

}  // namespace isotouch::commands
