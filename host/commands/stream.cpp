/// isotouch stream: frames of points, as they come → a field that grows at a running controller, under the hand.
#include <unistd.h>
#include <CLI/CLI.hpp>

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <system_error>
#include <thread>
#include <vector>

#include "host/board_commands/choice.h"
#include "host/board_commands/controller_options.h"
#include "host/board_commands/interruption.h"
#include "host/board_commands/number_in.h"
#include "host/board_commands/output.h"
#include "host/board_commands/print_json.h"
#include "host/cloud/read_mesh.h"
#include "host/commands/box_option.h"
#include "host/commands/camera_options.h"
#include "host/commands/commands.h"
#include "host/commands/quantities.h"
#include "host/commands/stream_report.h"
#include "host/error.h"
#include "host/field/parallel.h"
#include "host/field_file/packed.h"
#include "host/files/file_nature.h"
#include "host/files/whole_file.h"
#include "host/link/address.h"
#include "host/link/link_error.h"
#include "host/stream/sources.h"
#include "host/stream/stream.h"
#include "host/trace/hash_text.h"

namespace isotouch::commands {

namespace {

namespace fs = std::filesystem;

constexpr double kCameraRate = 30;
constexpr std::uint32_t kEnough = 16;  ///< points of a place: their mean has a quarter of the noise of one

struct StreamingOptions {
  std::vector<std::string> sources;
  fs::path mesh;
  evaluate::DepthCameraOptions camera;
  cloud::SensorOptions sensor;
  stream::StreamOptions stream;
  fs::path out, first;
  std::string units;
  double fit_mm = 70;
  bool is_fitted = false;  ///< somebody said so
  std::optional<double> rate, seconds, keep_s;
  bool every_frame = false;
  std::optional<std::uint32_t> enough;
  unsigned threads = 0;
  bool json = false;
};

enum class FrameSource { kFiles, kInput, kRecording, kController, kCamera };

bool is_address(const std::string& word) { return word.starts_with("unix:") || word.starts_with("ssh://"); }

bool is_recording(const fs::path& file) { return nature_of(file) == FileNature::kTrace; }

/// fails     CLI::ValidationError: sources that do not go together
FrameSource kind_of(const StreamingOptions& options) {
  const std::vector<std::string>& sources = options.sources;
  if (!options.mesh.empty()) {
    if (!sources.empty()) throw CLI::ValidationError("SOURCE", "the simulated camera is a source of its own; leave the others out");
    return FrameSource::kCamera;
  }
  if (sources.empty() || sources == std::vector<std::string>{"-"}) {
    if (isatty(STDIN_FILENO) != 0)
      throw CLI::ValidationError("SOURCE", "name files, a recording or a controller; frames on standard input come from a program");
    return FrameSource::kInput;
  }
  const auto single = [&](FrameSource kind, const char* what) {
    if (sources.size() > 1) throw CLI::ValidationError("SOURCE", std::string(what) + " is a source of its own; leave the others out");
    return kind;
  };
  for (const std::string& source : sources) {
    if (is_standard(source)) return single(FrameSource::kInput, "standard input");
    if (is_address(source)) return single(FrameSource::kController, "a controller");
    std::error_code failed;
    if (fs::is_fifo(source, failed))  // Ctrl-C could not end the wait for whoever writes to it
      throw CLI::ValidationError("SOURCE", source + " is a pipe; give frames on standard input, or name files");
    if (is_recording(source)) return single(FrameSource::kRecording, "a recording");
  }
  return FrameSource::kFiles;
}

/// Do two names lead to one file, which may not be there yet?
bool is_one_file(const fs::path& a, const fs::path& b) {
  if (a == b || b.empty() || is_standard(b)) return a == b;
  std::error_code failed;  // then a place is empty
  const auto place = [&failed](const fs::path& file) { return fs::weakly_canonical(fs::absolute(file, failed), failed); };
  return !place(a).empty() && place(a) == place(b);
}

/// What stays alive as long as a source.
struct Scene {
  std::optional<cloud::TriangleMesh> mesh;
  std::optional<field::TriangleTree> tree;
};

/// The object of the simulated camera, and a box with room for the camera's noise.
stream::Source camera_source(StreamingOptions& options, Scene& scene) {
  const cloud::TriangleMesh in_file = cloud::read_mesh(options.mesh);
  cloud::require_closed(in_file, options.mesh.string());
  Eigen::AlignedBox3d box;
  for (const Eigen::Vector3d& vertex : in_file.vertices) box.extend(vertex);
  constexpr double kRoom = 0.05;
  const Eigen::Vector3d more = Eigen::Vector3d::Constant(kRoom * box.sizes().maxCoeff());
  if (!options.stream.box) options.stream.box = Eigen::AlignedBox3d(box.min() - more, box.max() + more);
  const live::Space space = live::space_for(*options.stream.box, options.stream.space);
  scene.mesh = cloud::placed(in_file, space.placement);
  scene.tree.emplace(*scene.mesh);
  options.camera.frames_per_second = options.rate.value_or(kCameraRate);
  return stream::depth_camera(*scene.tree, space.placement, options.camera);
}

/// Touches, and what the simulated camera sees, have normals whose side is known.
void require_no_sensor(const StreamingOptions& options) {
  const auto refuse = [](const char* option, const char* what) {
    throw CLI::ValidationError(option, std::string("it is for ") + what + " in files or on standard input; leave it out");
  };
  if (options.sensor.camera) refuse("--intrinsics", "depth images");
  if (options.sensor.viewpoint) refuse("--viewpoint", "points");
  if (options.sensor.ignores_viewpoint) refuse("--no-viewpoint", "points");
}

stream::Source source_of(FrameSource kind, StreamingOptions& options, Scene& scene) {
  const double rate = options.rate.value_or(kCameraRate);
  if (kind != FrameSource::kFiles && kind != FrameSource::kInput) require_no_sensor(options);
  if (kind == FrameSource::kRecording || kind == FrameSource::kController) {
    if (!options.units.empty()) throw CLI::ValidationError("--units", "touches are in workspace mm; leave it out");
    if (options.is_fitted) throw CLI::ValidationError("--fit", "touches are in workspace mm; leave it out");
    options.stream.space.stays = true;
    const Eigen::Vector3d reach = Eigen::Vector3d::Constant(cloud::kFalconReach);
    if (!options.stream.box) options.stream.box = Eigen::AlignedBox3d(-reach, reach);
  }
  switch (kind) {
    case FrameSource::kFiles: return stream::files({options.sources.begin(), options.sources.end()}, options.rate, options.sensor);
    case FrameSource::kInput: return stream::standard_input(options.sensor, options.every_frame);
    case FrameSource::kRecording: return stream::recording(options.sources[0], rate, options.rate.has_value());
    case FrameSource::kController:
      if (!options.stream.to.empty() &&
          link::is_same_controller(link::read_address(options.sources[0]), link::read_address(options.stream.to)))
        throw UsageError(options.stream.to + ": the hand feels there what the stream has made; name another controller as the source");
      return stream::controller(options.sources[0], rate);
    case FrameSource::kCamera: return camera_source(options, scene);
  }
  return {};
}

void write_packed(const fs::path& file, const FieldView& view) {
  const std::vector<std::uint8_t> packed = field_file::pack(view);
  write_file(file, packed.data(), packed.size());
}

/// Writes the field as it is now, and reports.
void close(stream::Stream& of, const StreamingOptions& options) {
  const FieldView& view = of.whole().view;
  if (!options.out.empty()) write_packed(options.out, view);
  const std::string hash = trace::hash_text(view.hash());
  if (options.json) {
    print_json(summary_json(of, hash));
  } else {
    print_summary(of, hash, !options.stream.to.empty(), text_stream(options.out));
  }
  if (of.report().had_stiffness)
    std::fprintf(stderr, "isotouch: the live method has one stiffness for all, those of the points are left out\n");
  for (const std::string& reason : of.field()->verdict().reasons())
    std::fprintf(stderr, "isotouch: the field may be wrong: %s\n", reason.c_str());
}

/// What the controller may lack; empty: nothing, or somebody replaced the field.
std::string not_felt(const stream::Stream& stream) {
  if (stream.is_felt() || stream.is_replaced()) return {};
  return stream.report().upload_bytes > 0 ? "; the last frame may not be felt" : "; the controller confirmed nothing of this field";
}

/// Runs until the source ends, the time is over, or somebody wants an end.
///
/// hand      the controller whose hand is the source; empty: none
/// fails     InputError: as stream::Stream, but for a controller that is cut off, silent or refusing once the stream is to end
/// returns   why the controller has not confirmed all that was taken when the stream was to end; empty: it has
std::string work(stream::Stream& stream, stream::Source source, const StreamingOptions& options, const std::string& hand) {
  stream::Inbox inbox;
  const Interruption interruption;
  const stream::Clock::time_point begin = stream::Clock::now();
  const auto seconds = [begin] { return std::chrono::duration<double>(stream::Clock::now() - begin).count(); };
  std::uint64_t thinned = 0, heard = 0, lost = 0;
  const auto is_over = [&] { return interruption.has_come() || (options.seconds && seconds() >= *options.seconds); };
  try {
    stream.connect({.is_over = is_over, .second = [&](const stream::Tally& second) {
                      print_second(seconds(), inbox.thinned() - thinned, inbox.lost() - lost, inbox.heard() == heard ? hand : "", second,
                                   stream.fault());
                      thinned = inbox.thinned();
                      heard = inbox.heard();
                      lost = inbox.lost();
                    }});
    const std::jthread thread = stream::run(std::move(source), inbox);
    struct Closed {
      stream::Inbox& inbox;
      ~Closed() { inbox.close(); }
    } const closed{inbox};
    stream.run(inbox);
    stream.finish();
  } catch (const InputError& error) {
    const bool is_cut = dynamic_cast<const link::LinkError*>(&error) != nullptr;
    if (!is_over() || !(is_cut || stream.has_given_up())) throw;
    if (!options.stream.to.empty() && !stream.is_connected()) {
      throw InputError(options.stream.to + ": it had not answered when the " +
                       (interruption.has_come() ? "stream was interrupted; check whether it runs"
                                                : "time of --seconds was over; give more seconds, or check whether it runs"));
    }
    if (stream.is_felt()) return {};  // what ends this program may end the ssh to the controller, too
    const std::string silent = options.stream.to + ": the controller did not answer within " +
                               std::to_string(stream::Stream::kGrace.count()) + " s at the end; check whether it runs, then stream again";
    return (is_cut && stream.has_given_up() ? silent : error.what()) + not_felt(stream);
  }
  return {};
}

/// The same of frames: what was wrong with how many.
std::string nothing_of_frames(FrameSource kind, const stream::StreamReport& report) {
  const stream::Tally& all = report.all;
  std::string thinned;
  if (report.thinned > 0) thinned = "; " + std::to_string(report.thinned) + " frames were left out because newer ones came";
  if (report.thinned > 0 && kind == FrameSource::kInput) thinned += ", so use --every-frame";
  if (report.thinned > 0 && kind == FrameSource::kFiles) thinned += ", so leave out --rate";
  return "no frame had points with normals within the box, so nothing was built: of " + std::to_string(all.frames) + " frames " +
         std::to_string(all.empty) + " were empty and " + std::to_string(all.unoriented) + " without normals, " +
         std::to_string(all.points.outside) + " points lay outside the box, and " + std::to_string(all.points.useless) +
         " had no normal of about length 1" + thinned + "; check the normals, --box and --units";
}

/// Why there is no field.
std::string nothing_built(FrameSource kind, const StreamingOptions& options, const stream::StreamReport& report) {
  if (kind != FrameSource::kRecording && kind != FrameSource::kController) return nothing_of_frames(kind, report);
  const std::string& name = options.sources[0];
  if (report.all.points.outside > 0) return name + ": every touch was outside the box, so nothing was built; check --box";
  if (kind == FrameSource::kController && report.heard == 0)
    return name + ": no tick of the hand came, so nothing was built; check whether the controller runs";
  return name + ": no frame showed a touch, so nothing was built; let the hand touch the object";
}

void run(StreamingOptions& options) {
  const FrameSource kind = kind_of(options);
  if (options.every_frame && kind != FrameSource::kInput)
    throw UsageError("--every-frame is for frames on standard input; leave it out: files wait without --rate, and a device does not");
  const field::ThreadLimit limit(options.threads);
  if (!options.units.empty()) options.stream.space.size.mm_per_unit = cloud::mm_per_unit(options.units);
  options.stream.space.size.fit_mm = options.fit_mm;
  options.stream.viewpoint = options.sensor.viewpoint;
  if (options.keep_s) {
    options.stream.keep = std::chrono::duration_cast<stream::Clock::duration>(std::chrono::duration<double>(*options.keep_s));
  }
  const bool waits = (kind == FrameSource::kFiles || kind == FrameSource::kRecording) && !options.rate;
  options.stream.enough = options.enough.value_or(waits ? 0 : kEnough);
  if (!options.first.empty()) options.stream.on_first = [&options](const FieldView& view) { write_packed(options.first, view); };
  Scene scene;
  stream::Source source = source_of(kind, options, scene);
  stream::Stream stream(options.stream);
  std::string ended;
  try {
    ended = work(stream, std::move(source), options, kind == FrameSource::kController ? options.sources[0] : "");
  } catch (const InputError& error) {
    if (!stream.has_points()) throw;
    ended = error.what() + not_felt(stream);
    if (options.out.empty()) throw InputError(ended);
  }
  if (!stream.has_points()) throw InputError(nothing_built(kind, options, stream.report()));
  try {
    close(stream, options);
  } catch (const InputError& error) {
    if (ended.empty()) throw;
    throw InputError(ended + "; " + error.what());
  }
  if (!options.out.empty() && !ended.empty()) ended += "; " + options.out.string() + " holds the field as it was then";
  if (!ended.empty()) throw EndedEarly(ended);
}

}  // namespace

void add_stream(CLI::App& app) {
  auto options = std::make_shared<StreamingOptions>();
  CLI::App* command = app.add_subcommand(
      "stream", "Let a field grow at a running controller while its object is scanned; Ctrl-C ends it, and the field stays");
  command->add_option("SOURCE", options->sources,
                      "one of: files of points, a frame each (PLY, PCD or any that build reads); a recording (.trace); another controller "
                      "whose hand feels an object (unix:PATH or ssh://user@host); '-' or nothing: frames on standard input");
  CLI::Option* mesh =
      command->add_option("--camera", options->mesh, "instead of a SOURCE: a simulated depth camera that goes round this closed mesh");
  CLI::Option* to = add_optional_address(*command, options->stream.to);
  add_output(*command, "-o,--out", options->out, {&forms::kField}, "also write the field as it is at the end");
  add_output(*command, "--first", options->first, {&forms::kField},
             "also write the field that is uploaded first: a recording that the controller began before it replays on it");
  CLI::Option* name = command->add_option("--name", options->stream.name, "name of the field at the controller");
  name->check(field_name())->capture_default_str();
  add_box(*command, options->stream.box,
          "the part of space that is scanned, two corners in the input's coordinates; by default the box of the first frame "
          "and half of its longest side more on each side");
  CLI::Option* voxel = command->add_option("--voxel", options->stream.space.voxel_mm, "edge of a voxel, such as 0.5mm");
  voxel->transform(quantity(kLength, 1.0 / 64, 16));
  CLI::Option* grid = command->add_option("--grid", options->stream.space.grid, "voxels along the longest side of the box; by default 186");
  grid->check(whole_number_in(8, 4000))->excludes(voxel);
  command->add_option("--band", options->stream.space.band, "half width of the band around the surface that is stored, in voxels")
      ->check(number_in(1.0, 7.99))
      ->capture_default_str();
  command->add_option("--stiffness", options->stream.info.stiffness_n_per_mm, "stiffness of the surface")
      ->transform(quantity(kStiffness, 0.001, 100))
      ->capture_default_str();
  CLI::Option* fit = command->add_option("--fit", options->fit_mm, "scale the longest side of the box to this length, such as 70mm");
  fit->transform(quantity(kLength, 1, 1000))->capture_default_str();
  command->add_option("--units", options->units, "keep the true size; the unit of the input's coordinates")
      ->check(one_of({"mm", "cm", "m", "in"}))
      ->excludes(fit);
  command->add_option("--keep", options->keep_s, "seconds for which a point counts; by default for good")->check(number_in(0.01, 3600.0));
  command
      ->add_option("--enough", options->enough,
                   "largest number of points that count in one place, which is two voxels wide; 0: all of them. By default 16, and all of "
                   "files and recordings without --rate")
      ->check(whole_number_in(0, 1000000));
  command
      ->add_option("--rate", options->rate,
                   "frames per second: by default 30 of a camera and of touches; files and recordings come as fast as they are taken")
      ->check(number_in(0.1, 1000.0));
  command->add_flag("--every-frame", options->every_frame,
                    "with standard input: leave no frame out; whoever writes them waits until they are taken");
  command->add_option("--seconds", options->seconds, "how long at most; by default until the source ends")
      ->check(number_in(0.001, 86400.0));
  add_viewpoint(*command, options->sensor, "the sensor's place in the input's coordinates: every normal is turned towards it");
  auto intrinsics = std::make_shared<CameraOptions>();
  intrinsics->add_to(*command);
  command->add_option("--noise", options->camera.noise, "with --camera: standard deviation of a depth, such as 0.2mm")
      ->transform(quantity(kLength, 0, 10))
      ->needs(mesh);
  command->add_option("--dropouts", options->camera.dropouts, "with --camera: share of the pixels that return nothing")
      ->check(number_in(0.0, 1.0))
      ->needs(mesh);
  command->add_option("--turn", options->camera.turn_seconds, "with --camera: seconds for once round the object")
      ->check(number_in(0.1, 3600.0))
      ->needs(mesh)
      ->capture_default_str();
  command->add_option("--columns", options->camera.columns, "with --camera: pixels across; it has three quarters as many rows")
      ->check(whole_number_in(8, 4000))
      ->needs(mesh)
      ->capture_default_str();
  command->add_option("--seed", options->camera.seed, "with --camera: seed of noise and dropouts")->needs(mesh)->capture_default_str();
  command
      ->add_option("--threads", options->threads, "number of threads; by default one for each processor. The result does not depend on it")
      ->check(whole_number_in(1, 1024));
  command->add_flag("--json", options->json, "print one JSON object at the end");
  command->callback([options, intrinsics, to, name, fit] {
    if (to->count() == 0 && options->out.empty()) throw CLI::ValidationError("--to", "name a controller, or a file with -o, or both");
    if (is_standard(options->first)) throw CLI::ValidationError("--first", "it is written while the stream runs; name a file");
    if (!options->first.empty() && is_one_file(options->first, options->out))
      throw CLI::ValidationError("--first", "-o would write over it at the end; name another file");
    if (!options->first.empty() && to->count() == 0) throw CLI::ValidationError("--first", "nothing is uploaded without --to");
    if (name->count() > 0 && to->count() == 0) throw CLI::ValidationError("--name", "nothing is uploaded without --to");
    require_apart(options->out, options->json);
    options->is_fitted = fit->count() > 0;
    options->sensor.camera = intrinsics->camera();
    evaluate::DepthCameraOptions& camera = options->camera;
    camera.rows = std::max<std::size_t>(camera.columns * 3 / 4, 2);
    camera.focal_pixels = 1.125 * static_cast<double>(camera.columns);
    run(*options);
  });
}

}  // namespace isotouch::commands
