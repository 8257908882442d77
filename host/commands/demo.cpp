/// isotouch demo: the whole way in one command. A cloud becomes a field, the field is felt by the core along a tour, the tour is repeated to the
/// bit, the force is compared with a sphere's exact one, and pictures are written.
#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <system_error>
#include <vector>

#include "host/board_commands/choice.h"
#include "host/board_commands/output.h"
#include "host/board_commands/print_json.h"
#include "host/cloud/check.h"
#include "host/cloud/ply.h"
#include "host/cloud/shapes.h"
#include "host/commands/built_field.h"
#include "host/commands/commands.h"
#include "host/commands/recorded_ticks.h"
#include "host/error.h"
#include "host/evaluate/force_error.h"
#include "host/evaluate/shape_trial.h"
#include "host/files/whole_file.h"
#include "host/motion/motion.h"
#include "host/to_double.h"
#include "host/trace/hash_text.h"
#include "host/trace/replay.h"
#include "host/view/force_picture.h"
#include "host/view/picture.h"
#include "host/view/points_picture.h"
#include "host/view/slice_picture.h"
#include "host/view/surface_picture.h"

namespace isotouch::commands {

namespace {

namespace fs = std::filesystem;

struct DemoOptions {
  fs::path cloud;  // empty: the hydrant
  fs::path folder = "build/demo";
  char up = 'y';
  bool json = false;
};

struct Tour {
  trace::ReplayReport first;
  bool repeated = false;  // the second run gave the same bits
  view::Touch shown;      // one that a person recognises
};

struct SphereForce {
  evaluate::ForceError worst;  // of the speeds that are judged
  view::ForceCurve felt{"as the core renders it", {}, {}}, exact{"exact", {}, {}};
};

/// For lines that tell what is going on: standard output belongs to the report.
void say(const char* what) { std::fprintf(stderr, "%s\n", what); }

/// The hydrant's points, drawn into a file like anybody's.
fs::path hydrant(const fs::path& folder) {
  const cloud::Shape shape = cloud::shape("hydrant");
  const fs::path file = folder / "hydrant.ply";
  cloud::write_ply(file, cloud::sample_shape(shape, shape.default_points), "isotouch demo: " + shape.sentence);
  return file;
}

/// All gestures over the object, recorded, and replayed against the recording.
Tour feel(const FieldView& field, const fs::path& folder, char up) {
  const TraceHeader header;
  const fs::path inputs = folder / "tour.inputs.trace", recorded = folder / "tour.trace";
  trace::TraceWriter writer(inputs, header);
  std::uint64_t tick = 0;
  motion::make_motion(&field, {}, [&](const Input& input) { writer.append({input, {}, 0, header.period_ns * tick++}); });
  writer.finish();

  const trace::Trace trace = trace::read_trace(inputs);
  trace::TraceWriter out(recorded, trace::replay_header(field, trace.header()));
  Tour tour;
  tour.first = trace::replay(field, trace, false, &out);
  out.finish();
  const trace::Trace with_outputs = trace::read_trace(recorded);
  const trace::ReplayReport again = trace::replay(field, with_outputs, true);
  tour.repeated = !again.first_difference && again.hash == tour.first.hash;
  tour.shown = clear_touch(with_outputs, field, up);
  return tour;
}

/// The paper's Fig. 9: sliding 4 voxels deep, by numbers at 100 and 300 mm/s; for the picture a hand that comes, slides and leaves.
SphereForce sphere_force() {
  const evaluate::ShapeTrial trial = evaluate::shape_trial("sphere");
  const field_file::OpenField field = evaluate::trial_field(trial, Method::kDefault);
  SphereForce result;
  evaluate::SphereSlide slide;
  for (const double speed : {100.0, 300.0}) {
    slide = evaluate::trial_slide(field.view, speed);
    const evaluate::ForceError error =
        evaluate::force_error(evaluate::slide_on_sphere(slide, evaluate::core_force(field.view, slide.period_s)));
    result.worst.ticks += error.ticks;
    result.worst.magnitude_rms_pct = std::max(result.worst.magnitude_rms_pct, error.magnitude_rms_pct);
    result.worst.direction_max_deg = std::max(result.worst.direction_max_deg, error.direction_max_deg);
  }
  const evaluate::ForceTick tick = evaluate::core_force(field.view, slide.period_s);
  motion::MotionOptions motion;
  motion.kind = "slide";
  motion::make_motion(&field.view, motion, [&](const Input& input) {
    const Eigen::Vector3d hip = to_double(input.hip);
    const double now = static_cast<double>(result.felt.time_s.size()) * slide.period_s;
    for (view::ForceCurve* curve : {&result.felt, &result.exact}) curve->time_s.push_back(now);
    const Eigen::Vector3d from_centre = hip - slide.centre;
    result.felt.force.push_back(tick(hip));
    result.exact.force.push_back(slide.stiffness * std::max(0.0, slide.radius - from_centre.norm()) * from_centre.normalized());
  });
  return result;
}

std::vector<fs::path> draw(const DemoOptions& options, const std::string& title, const BuiltField& built, const Tour& tour,
                           const SphereForce& force) {
  const std::vector<fs::path> files = {options.folder / "points.png", options.folder / "surface.png", options.folder / "slice.png",
                                       options.folder / "force.png"};
  view::write_picture(files[0], view::points_picture(built.points, {.direction = {.up = options.up},
                                                                    .title = title,
                                                                    .spacing = cloud::median_spacing(built.points.positions),
                                                                    .mm_per_unit = 1}));
  view::write_picture(
      files[1],
      view::surface_picture(built.field.view, {.up = options.up, .touch = tour.shown, .title = title, .invented = built.field.invented}));
  view::write_picture(files[2], view::slice_picture(built.field.view, {.touch = tour.shown, .title = title}));
  view::write_picture(files[3], view::force_picture(force.felt, &force.exact, {.title = "sliding on a sphere"}));
  return files;
}

void print_report(const BuiltField& built, const Tour& tour, const SphereForce& force, const std::vector<fs::path>& pictures) {
  nlohmann::ordered_json stages = nlohmann::ordered_json::object();
  for (const auto& [stage, seconds] : built.report.stages) stages[stage] = seconds;
  nlohmann::ordered_json json = {
      {"points", built.report.points},
      {"inside_nodes", built.report.inside_nodes},
      {"seconds", built.report.seconds},
      {"stages", stages},
      {"bytes", built.field.image.size()},
      {"hash", trace::hash_text(built.field.view.hash())},
      {"ticks", tour.first.ticks},
      {"ticks_per_second", static_cast<double>(tour.first.ticks) / tour.first.seconds},
      {"replay_hash", trace::hash_text(tour.first.hash)},
      {"force", {{"magnitude_rms_pct", force.worst.magnitude_rms_pct}, {"direction_max_deg", force.worst.direction_max_deg}}}};
  json["pictures"] = nlohmann::ordered_json::array();
  for (const fs::path& picture : pictures) json["pictures"].push_back(picture.string());
  print_json(json);
}

void print_text(const std::string& title, const BuiltField& built, const Tour& tour, const SphereForce& force,
                const std::vector<fs::path>& pictures) {
  const BuildReport& report = built.report;
  const auto& size = built.field.view.size;
  std::printf("object          %s\n", title.c_str());
  std::printf("points          %zu\n", report.points);
  std::printf("grid            %d × %d × %d samples, voxel %.3f mm\n", size[0], size[1], size[2], to_double(built.field.view.edge));
  std::printf("inside nodes    %zu\n", report.inside_nodes);
  std::printf("build           %.2f s:", report.seconds);
  for (const auto& [stage, seconds] : report.stages) std::printf(" %s %.2f", stage.c_str(), seconds);
  std::printf("\nfield            %.2f MB, hash %s\n", static_cast<double>(built.field.image.size()) * 1e-6,
              trace::hash_text(built.field.view.hash()).c_str());
  std::printf("tour            %llu ticks, %.0f ticks a second with their hash chain\n", static_cast<unsigned long long>(tour.first.ticks),
              static_cast<double>(tour.first.ticks) / tour.first.seconds);
  std::printf("replay          hash %s, repeated: equal, every bit\n", trace::hash_text(tour.first.hash).c_str());
  std::printf("touch shown     %.2f mm deep, %.2f N, at tick %zu\n", tour.shown.depth_mm(), tour.shown.force.norm(), tour.shown.tick);
  std::printf("sphere's force  magnitude rms error %.4f %%, direction error at most %.4f° (4 voxels deep, 100 and 300 mm/s, %zu ticks)\n",
              force.worst.magnitude_rms_pct, force.worst.direction_max_deg, force.worst.ticks);
  std::printf("pictures       ");
  for (const fs::path& picture : pictures) std::printf(" %s", picture.string().c_str());
  std::printf("\n");
}

/// Which file to open, and what to do next.
void print_next(const DemoOptions& options, const std::string& title, const Tour& tour, const std::vector<fs::path>& pictures) {
  const std::string field = (options.folder / (title + ".itf")).string();
  std::printf("\nOpen %s: a hand presses %.1f mm into the object, and the surface holds its proxy back.\n", pictures[1].string().c_str(),
              tour.shown.depth_mm());
  std::printf("To see it from another side: isotouch render surface %s --trace %s --view -60,20 -o %s\n", field.c_str(),
              (options.folder / "tour.trace").string().c_str(), (options.folder / "other.png").string().c_str());
  std::printf("To do the same with a scan of yours: isotouch demo SCAN\n");
}

void run(const DemoOptions& options) {
  std::error_code failed;
  fs::create_directories(options.folder, failed);
  if (failed) throw InputError(options.folder.string() + ": the folder cannot be made: " + failed.message());
  const fs::path cloud = options.cloud.empty() ? hydrant(options.folder) : options.cloud;
  const std::string title = is_standard(cloud) ? "scan" : cloud.stem().string();

  say("building the field");
  BuildOptions build;
  build.input = cloud;
  build.as = SourceKind::kCloud;
  build.out = options.folder / (title + ".itf");
  const BuiltField built = built_field(build);
  say("feeling it along a tour");
  const Tour tour = feel(built.field.view, options.folder, options.up);
  if (!tour.repeated) throw ComparisonFailed("the tour's replay is not equal to its recording");
  say("comparing the force with a sphere's");
  const SphereForce force = sphere_force();
  say("drawing");
  const std::vector<fs::path> pictures = draw(options, title, built, tour, force);
  if (options.json) {
    print_report(built, tour, force, pictures);
  } else {
    print_text(title, built, tour, force, pictures);
    print_next(options, title, tour, pictures);
  }
}

}  // namespace

void add_demo(CLI::App& app) {
  auto options = std::make_shared<DemoOptions>();
  CLI::App* command = app.add_subcommand("demo", "Do all steps from points to forces and pictures; takes a few seconds");
  command->add_option("CLOUD", options->cloud, "points: PLY, OBJ, PCD or text; by default a built-in hydrant");
  command->add_option("-o,--out", options->folder, "folder for the field, traces and pictures")
      ->capture_default_str()
      ->each(require_folder);
  command->add_option("--up", options->up, "the cloud's axis that points upwards on the pictures: x, y or z")
      ->check(one_of({"x", "y", "z"}))
      ->capture_default_str();
  command->add_flag("--json", options->json, "print one JSON object");
  command->callback([options] { run(*options); });
}

}  // namespace isotouch::commands
