/// isotouch render: pictures of points, surfaces and slices.
#include <charconv>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <system_error>
#include <utility>

#include "host/board_commands/choice.h"
#include "host/board_commands/number_in.h"
#include "host/cloud/check.h"
#include "host/cloud/read_cloud.h"
#include "host/commands/camera_options.h"
#include "host/commands/commands.h"
#include "host/commands/picture_options.h"
#include "host/commands/progress_bar.h"
#include "host/commands/recorded_ticks.h"
#include "host/error.h"
#include "host/field/sound_scan.h"
#include "host/field_file/open_field.h"
#include "host/trace/trace_file.h"
#include "host/view/picture.h"
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
    ProgressBar bar({{"points", 1}});
    bar.begin("points");
    cloud::OrientedPoints points = cloud::read_cloud({cloud, {camera.camera(), {}}}, report);
    field::SoundScan sound;
    try {
      sound = field::sound_scan(
          points,
          {.estimate = !report.has_normals, .viewpoint = report.has_normals ? std::nullopt : report.sensor.place, .name = cloud.string()});
    } catch (const InputError&) {
      if (!report.has_normals) throw;  // else it is drawn as it is, too poor to have a rim
    }
    if (!report.has_normals) {  // what was found instead; else the file's own, strays and all
      sound.drop_invented();
      points = std::move(sound.points);
    }
    view::write_picture(picture.out,
                        view::points_picture(points, {.width = picture.size[0],
                                                      .height = picture.size[1],
                                                      .direction = picture.direction().value_or(view::Direction{.up = picture.up}),
                                                      .title = cloud.stem().string(),
                                                      .spacing = cloud::median_spacing(points.positions),
                                                      .mm_per_unit = 0,
                                                      .rim_length = sound.rim.length,
                                                      .rim = sound.rim.links}));
  }
};

/// Which touch of a recorded hand a picture shows.
struct TouchOptions {
  fs::path trace;
  std::string tick = "clear";

  CLI::Option* add_to(CLI::App& command) {
    CLI::Option* option = command.add_option("--trace", trace, "show the touch of a recorded hand");
    command
        .add_option("--tick", tick,
                    "which tick of it: a number, deepest, or clear, which is a touch between 1 and 2 mm deep that is easy to see")
        ->needs(option)
        ->capture_default_str();
    return option;
  }
  /// A touch, and the field that it felt.
  struct Shown {
    const FieldView& given;
    std::optional<view::Touch> touch = {};
    std::optional<trace::FeltField> felt = {};

    const FieldView& field() const { return felt ? *felt->now() : given; }
  };

  /// field     of the recording; what its patches make of it is shown at a later tick
  Shown shown(const FieldView& field, char up) const {
    Shown shown{field};
    if (trace.empty()) return shown;
    const trace::Trace recorded = trace::read_trace(trace);
    shown.touch = touch(recorded, field, up);
    shown.felt.emplace(felt_at(recorded, field, shown.touch->tick));
    return shown;
  }

 private:
  view::Touch touch(const trace::Trace& recorded, const FieldView& field, char up) const {
    if (tick == "clear") return clear_touch(recorded, field, up);
    if (tick == "deepest") return deepest_touch(recorded, field);
    std::size_t number = 0;
    const auto [end, error] = std::from_chars(tick.data(), tick.data() + tick.size(), number);
    if (error == std::errc() && end == tick.data() + tick.size() && number < recorded.size()) return touch_at(recorded, field, number);
    throw InputError(trace.string() + ": there is no tick '" + tick + "'; name one from 0 to " + std::to_string(recorded.size() - 1) +
                     ", or deepest, or clear");
  }
};

struct SurfaceRun {
  PictureOptions picture;
  fs::path field;
  TouchOptions touch;

  void operator()() const {
    const field_file::OpenField open = field_file::open_field(field);
    const TouchOptions::Shown shown = touch.shown(open.view, picture.up);
    const bool is_patched = shown.field().hash() != open.view.hash();  // then the marks are those of other bricks
    const view::SurfaceOptions options{.width = picture.size[0],
                                       .height = picture.size[1],
                                       .direction = picture.direction(),
                                       .up = picture.up,
                                       .touch = shown.touch,
                                       .title = field.stem().string(),
                                       .invented = is_patched ? field_file::Marks{} : open.invented};
    ProgressBar bar({{"surface", 1e-6 * picture.size[0] * picture.size[1]}});
    bar.begin("surface");
    const view::Picture drawn = view::surface_picture(shown.field(), options);
    bar.end();
    view::write_picture(picture.out, drawn);
  }
};

struct SliceRun {
  PictureOptions picture;
  fs::path field;
  std::optional<char> axis;
  std::optional<double> at;
  TouchOptions touch;

  void operator()() const {
    const field_file::OpenField open = field_file::open_field(field);
    const TouchOptions::Shown shown = touch.shown(open.view, picture.up);
    view::write_picture(picture.out, view::slice_picture(shown.field(), {.width = picture.size[0],
                                                                         .height = picture.size[1],
                                                                         .axis = axis,
                                                                         .at_mm = at,
                                                                         .touch = shown.touch,
                                                                         .title = field.stem().string()}));
  }
};

}  // namespace

void add_render(CLI::App& app) {
  CLI::App* render = app.add_subcommand("render", "Write a picture of points, a surface or a slice");
  render->require_subcommand(1);

  const auto [points, points_run] = add_picture<PointsRun>(*render, "points", "Oriented points as small lit discs");
  points->add_option("CLOUD", points_run->cloud, "PLY, OBJ, PCD, text, or a depth image (16-bit PNG)")->required();
  points_run->picture.add_view_to(*points);
  points_run->camera.add_to(*points);

  const auto [surface, surface_run] = add_picture<SurfaceRun>(*render, "surface", "The lit zero surface as the core samples it");
  surface->add_option("FIELD", surface_run->field, "the field (.itf)")->required();
  surface_run->touch.add_to(*surface);
  surface_run->picture.add_view_to(*surface);

  const auto [slice, slice_run] = add_picture<SliceRun>(*render, "slice", "A cross-section of the field in colours, with its contours");
  slice->add_option("FIELD", slice_run->field, "the field (.itf)")->required();
  slice
      ->add_option_function<std::string>(
          "--axis", [run = slice_run](const std::string& name) { run->axis = name.front(); },
          "across the slice; by default z, or with --trace the axis that shows the touch best")
      ->check(one_of({"x", "y", "z"}));
  CLI::Option* at = slice->add_option("--at", slice_run->at, "mm on that axis, workspace; default: where the object is widest")
                        ->check(number_in(-512.0, 512.0));
  slice_run->touch.add_to(*slice)->excludes(at);
}

}  // namespace isotouch::commands
