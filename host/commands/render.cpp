/// isotouch render: pictures of points, surfaces, slices and forces.
#include <algorithm>
#include <charconv>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <system_error>
#include <utility>

#include "host/board_commands/choice.h"
#include "host/cloud/check.h"
#include "host/cloud/read_cloud.h"
#include "host/commands/camera_options.h"
#include "host/commands/commands.h"
#include "host/commands/picture_options.h"
#include "host/commands/recorded_ticks.h"
#include "host/error.h"
#include "host/field/sound_scan.h"
#include "host/field_file/open_field.h"
#include "host/to_double.h"
#include "host/trace/trace_file.h"
#include "host/view/caption.h"
#include "host/view/force_picture.h"
#include "host/view/png_file.h"
#include "host/view/points_picture.h"
#include "host/view/slice_picture.h"
#include "host/view/surface_picture.h"

namespace isotouch::commands {

namespace {

namespace fs = std::filesystem;

struct PointsRun {
  PictureOptions picture;
  fs::path cloud;
  CameraOptions camera;

  void operator()() const {
    cloud::CloudReport report;
    cloud::OrientedPoints points = cloud::read_cloud({cloud, {camera.camera(), {}}}, report);
    if (!report.has_normals) {
      field::SoundScan sound = field::sound_scan(std::move(points), {.estimate = true, .viewpoint = report.viewpoint});
      sound.drop_invented();
      points = std::move(sound.points);
    }
    view::write_png(picture.out, view::points_picture(points, {.width = picture.size[0],
                                                               .height = picture.size[1],
                                                               .direction = picture.direction().value_or(view::Direction{.up = picture.up}),
                                                               .title = cloud.stem().string(),
                                                               .spacing = cloud::median_spacing(points.positions),
                                                               .mm_per_unit = 0}));
  }
};

struct SurfaceRun {
  PictureOptions picture;
  fs::path field;
  fs::path trace;
  std::string tick = "deepest";

  void operator()() const {
    const field_file::OpenField open = field_file::open_field(field);
    view::SurfaceOptions options{.width = picture.size[0],
                                 .height = picture.size[1],
                                 .direction = picture.direction(),
                                 .up = picture.up,
                                 .touch = std::nullopt,
                                 .title = field.stem().string()};
    if (!trace.empty()) {
      const trace::Trace recorded = trace::read_trace(trace);
      options.touch = tick == "deepest" ? deepest_touch(recorded, open.view) : touch_at(recorded, open.view, parse_tick(recorded.size()));
    }
    view::write_png(picture.out, view::surface_picture(open.view, options));
  }

  std::size_t parse_tick(std::size_t count) const {
    std::size_t number = 0;
    const auto [end, error] = std::from_chars(tick.data(), tick.data() + tick.size(), number);
    if (error == std::errc() && end == tick.data() + tick.size() && number < count) return number;
    throw InputError(trace.string() + ": there is no tick '" + tick + "'; name one from 0 to " + std::to_string(count - 1) +
                     ", or deepest");
  }
};

struct SliceRun {
  PictureOptions picture;
  fs::path field;
  char axis = 'z';
  std::optional<double> at;

  void operator()() const {
    const field_file::OpenField open = field_file::open_field(field);
    view::write_png(
        picture.out,
        view::slice_picture(
            open.view, {.width = picture.size[0], .height = picture.size[1], .axis = axis, .at_mm = at, .title = field.stem().string()}));
  }
};

struct ForceRun {
  PictureOptions picture;
  fs::path trace;
  fs::path field;
  double sphere_mm = 0;

  void operator()() const {
    const trace::Trace recorded = trace::read_trace(trace);
    std::optional<field_file::OpenField> open;
    if (!field.empty()) open.emplace(field_file::open_field(field));
    const double limit = to_double(recorded.header().settings.force_limit);
    const double stiffness = sphere_mm > 0 ? stiffness_of(recorded, open ? &open->view : nullptr) : 0;
    view::ForceCurve curve;
    for_each_tick(recorded, open ? &open->view : nullptr, [&](std::size_t tick, const TraceRecord& record) {
      curve.time_s.push_back(static_cast<double>(tick) * recorded.header().period_ns * 1e-9);
      curve.felt_n.push_back(to_double(record.output.force).norm());
      if (sphere_mm <= 0) return;
      const double depth = std::max(0.0, sphere_mm - to_double(record.output.hip).norm());
      curve.exact_n.push_back(std::min(stiffness * depth, limit));
    });
    view::write_png(picture.out, view::force_picture(curve, {.width = picture.size[0],
                                                             .height = picture.size[1],
                                                             .title = trace.stem().string(),
                                                             .exact_label = "exact, sphere of " + view::number(sphere_mm, 3) + " mm"}));
  }

  double stiffness_of(const trace::Trace& recorded, const FieldView* touched) const {
    const Stiffness set = recorded.header().settings.stiffness;
    if (set.raw() != 0) return to_double(set);
    if (touched == nullptr) throw InputError(trace.string() + ": its stiffness is that of the field; name the field with --field");
    return to_double(touched->stiffness);
  }
};

/// A sub-command whose options live as long as the parser.
template <class Run>
std::pair<CLI::App*, Run*> add(CLI::App& parent, const char* name, const char* about) {
  auto run = std::make_shared<Run>();
  CLI::App* command = parent.add_subcommand(name, about);
  run->picture.add_to(*command);
  command->callback([run] { (*run)(); });
  return {command, run.get()};
}

}  // namespace

void add_render(CLI::App& app) {
  CLI::App* render = app.add_subcommand("render", "Write a picture (PNG) of points, a surface, a slice or a force");
  render->require_subcommand(1);

  const auto [points, points_run] = add<PointsRun>(*render, "points", "Oriented points as small lit discs");
  points->add_option("CLOUD", points_run->cloud, "PLY, OBJ, PCD, text, or a depth image (16-bit PNG)")->required();
  points_run->picture.add_view_to(*points);
  points_run->camera.add_to(*points);

  const auto [surface, surface_run] = add<SurfaceRun>(*render, "surface", "The lit zero surface as the core samples it");
  surface->add_option("FIELD", surface_run->field, "the field (.itf)")->required();
  CLI::Option* trace = surface->add_option("--trace", surface_run->trace, "show the touch of a recorded hand");
  surface->add_option("--tick", surface_run->tick, "which tick of it: a number, or deepest")->needs(trace)->capture_default_str();
  surface_run->picture.add_view_to(*surface);

  const auto [slice, slice_run] = add<SliceRun>(*render, "slice", "A cross-section of the field in colours, with its contours");
  slice->add_option("FIELD", slice_run->field, "the field (.itf)")->required();
  slice->add_option("--axis", slice_run->axis, "across the slice")->check(one_of({"x", "y", "z"}))->capture_default_str();
  slice->add_option("--at", slice_run->at, "mm on that axis, workspace; default: where the object is widest");

  const auto [force, force_run] = add<ForceRun>(*render, "force", "Force over time of a recorded hand");
  force->add_option("TRACE", force_run->trace, "the recorded hand (.trace)")->required();
  force->add_option("--field,--blob", force_run->field, "for a trace that holds inputs only, or takes its stiffness from the field");
  force->add_option("--exact-sphere", force_run->sphere_mm, "beside it the exact answer of a sphere of this radius (mm) round the origin")
      ->check(CLI::PositiveNumber);
}

}  // namespace isotouch::commands
