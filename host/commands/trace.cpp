/// isotouch trace: make a motion, import one, derive others, find where two traces differ first.
#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <system_error>
#include <vector>

#include "host/bag/bag_motion.h"
#include "host/bag/trace_to_mcap.h"
#include "host/board_commands/choice.h"
#include "host/board_commands/number_in.h"
#include "host/board_commands/output.h"
#include "host/board_commands/trace_show.h"
#include "host/board_commands/trace_stop_latency.h"
#include "host/commands/commands.h"
#include "host/commands/quantities.h"
#include "host/commands/temporary_folder.h"
#include "host/commands/trace_mutate.h"
#include "host/error.h"
#include "host/field_file/open_field.h"
#include "host/files/whole_file.h"
#include "host/motion/device_in_hand.h"
#include "host/motion/felt_surface.h"
#include "host/motion/motion.h"
#include "host/motion/motion_csv.h"
#include "host/motion/resample.h"
#include "host/to_double.h"
#include "host/trace/replay.h"
#include "host/trace/trace_diff.h"
#include "host/trace/trace_file.h"
#include "shared/device_model.h"
#include "shared/files/version_text.h"
#include "shared/trace.h"

namespace isotouch::commands {

namespace {

namespace fs = std::filesystem;

/// The options of the tick settings, in the order of kTickSettingRows.
constexpr std::array<const char*, kTickSettings> kSettingOptions = {
    "--stiffness", "--damping", "--force-limit",    "--friction", "--friction-damping", "--hand-damping", "--passivity-damping",
    "--weight",    "--ramp",    "--device-damping", "--delay"};

/// What every new trace has in its header.
struct NewTrace {
  fs::path out;
  double period_ms = rows::kPeriod.standard / kNsPerMs;
  std::array<double, kTickSettings> settings{};  ///< in the unit of each row

  NewTrace() {
    for (std::size_t i = 0; i < kTickSettings; ++i) settings[i] = kTickSettingRows[i]->standard;
  }

  void add_to(CLI::App& command) {
    add_output(command, "-o,--out", out, {&forms::kTrace}, "the trace to write")->required();
    command.add_option("--period", period_ms, "tick period")
        ->transform(quantity({{"ms", 1.0}, {"us", 0.001}, {"s", 1000.0}}, rows::kPeriod.low / kNsPerMs, rows::kPeriod.high / kNsPerMs))
        ->capture_default_str();
    for (std::size_t i = 0; i < kTickSettings; ++i) {
      command.add_option(kSettingOptions[i], settings[i], std::string(kTickSettingRows[i]->meaning))
          ->transform(value_of(*kTickSettingRows[i]))
          ->capture_default_str();
    }
  }

  TraceHeader header() const {
    TraceHeader made;
    made.period_ns = static_cast<std::uint32_t>(period_ms * kNsPerMs + 0.5);
    RawSettings raw{};
    for (std::size_t i = 0; i < kTickSettings; ++i) raw[i] = kTickSettingRows[i]->raw(settings[i]);
    made.settings = from_raw(raw);
    return made;
  }

  double stiffness() const { return settings[index_of(TickSetting::kStiffness)]; }

 private:
  static constexpr double kNsPerMs = 1e6;
};

/// Ticks as they come, one period apart.
class TickWriter {
 public:
  TickWriter(const NewTrace& trace, bool has_outputs)
      : header_(with_outputs(trace.header(), has_outputs)), writer_(trace.out, header_), chain_(header_) {}
  void operator()(const Input& input) { writer_.append({input, {}, 0, header_.period_ns * tick_++}); }
  /// Only with outputs.
  void operator()(const Input& input, const Output& output) {
    writer_.append({input, output, chain_.extend(input, output), header_.period_ns * tick_++});
  }
  void finish() { writer_.finish(); }

 private:
  static TraceHeader with_outputs(TraceHeader header, bool has_outputs) {
    header.has_outputs = has_outputs;
    return header;
  }
  TraceHeader header_;
  trace::TraceWriter writer_;
  Chain chain_;
  std::uint64_t tick_ = 0;
};

void report(const fs::path& file, std::uint64_t ticks, const TraceHeader& header) {
  std::fprintf(stderr, "%s: %llu ticks, %.3f s\n", file.string().c_str(), static_cast<unsigned long long>(ticks),
               static_cast<double>(ticks) * header.period_ns * 1e-9);
}

struct MakeOptions {
  NewTrace trace;
  motion::MotionOptions motion;
  double lost_percent = 0.0;
  fs::path field;
};

void make_trace(const MakeOptions& options) {
  std::optional<field_file::OpenField> field;
  if (!options.field.empty()) field.emplace(field_file::open_field(options.field));
  motion::MotionOptions motion = options.motion;
  motion.period_ns = options.trace.header().period_ns;
  motion.lost_share = options.lost_percent / 100;
  TickWriter writer(options.trace, false);
  const std::uint64_t ticks = motion::make_motion(field ? &field->view : nullptr, motion, [&](const Input& input) { writer(input); });
  writer.finish();
  report(options.trace.out, ticks, options.trace.header());
}

struct ImportOptions {
  NewTrace trace;
  fs::path source;
  std::string topic, force_topic;
  std::string given;  ///< an option that changes what is imported; empty: there is none
  std::string columns;
  std::string time_unit;
  std::string length_unit;
  bool forces = false;
  bool centre = false;
  double scale = 1.0;
  std::vector<double> offset = {0, 0, 0};
  fs::path into;
};

/// Centred first, then scaled, then moved.
void place(std::vector<motion::TimedPoint>& points, ImportOptions options) {
  Eigen::Vector3d low = points.front().position;
  Eigen::Vector3d high = low;
  for (const auto& point : points) {
    low = low.cwiseMin(point.position);
    high = high.cwiseMax(point.position);
  }
  const Eigen::Vector3d middle = options.centre || !options.into.empty() ? Eigen::Vector3d((low + high) / 2) : Eigen::Vector3d::Zero();
  Eigen::Vector3d offset(options.offset[0], options.offset[1], options.offset[2]);
  if (!options.into.empty()) {
    const field_file::OpenField field = field_file::open_field(options.into);
    const motion::FeltSurface object(field.view);
    const double widest = (high - low).maxCoeff();
    if (!(widest > 0)) throw InputError(options.source.string() + ": the motion stays at one place and cannot be scaled; leave --into out");
    options.scale = object.voxel_mm() * (*std::max_element(field.view.size.begin(), field.view.size.end()) - 1) / widest;
    offset = object.centre();
  }
  for (auto& point : points) point.position = options.scale * (point.position - middle) + offset;
}

/// What another device felt, as a tick puts it: the proxy where the stiffness says that the surface was.
Output felt(const Input& input, const Eigen::Vector3d& force, double stiffness) {
  Output output;
  output.hip = input.hip;
  output.force = to_fixed<Newton>(force);
  output.status = output.force == Vec3<Newton>{} ? 0U : kContact;
  const Eigen::Vector3d hip = to_double(input.hip);
  output.proxy = to_fixed<Mm>(stiffness > 0 ? Eigen::Vector3d(hip + force / stiffness) : hip);
  return output;
}

/// A trace that was exported comes back as it was; what else the recording holds is left out.
bool bring_back(const ImportOptions& options) {
  if (!options.topic.empty() || !bag::is_bag(options.source)) return false;
  const std::optional<bag::Bytes> whole = bag::attached_trace(options.source);
  if (!whole) return false;
  if (!options.given.empty()) {
    throw InputError(options.source.string() + ": it holds a whole trace, which comes back as it was; leave " + options.given +
                     " out, or name the positions to import anew with --topic");
  }
  const TemporaryFolder folder;
  const fs::path looked_at = folder.path / "attached.trace";
  write_file(looked_at, whole->data(), whole->size());
  try {
    (void)trace::read_trace(looked_at);
  } catch (const InputError& error) {
    throw InputError(options.source.string() + ": the trace that it holds cannot be read (" + error.what() +
                     "); choose a topic with --topic");
  }
  write_file(options.trace.out, whole->data(), whole->size());
  std::fprintf(stderr, "%s: the trace that %s holds, to the bit\n", options.trace.out.string().c_str(), options.source.string().c_str());
  return true;
}

void import_table(const ImportOptions& options) {
  if (bring_back(options)) return;
  motion::MotionColumns columns = motion::parse_columns(options.columns);
  columns.time_unit = options.time_unit;
  columns.length_unit = options.length_unit;
  columns.with_forces = options.forces;
  std::vector<motion::TimedPoint> points = bag::is_bag(options.source)
                                               ? bag::read_bag_motion(options.source, {options.topic, options.force_topic, options.forces})
                                               : motion::read_motion_csv(options.source, columns);
  place(points, options);
  TickWriter writer(options.trace, options.forces);
  std::uint64_t ticks = 0;
  try {
    ticks = motion::resample(points, options.trace.header().period_ns, [&](const Input& input, const Eigen::Vector3d& force) {
      if (options.forces) {
        writer(input, felt(input, force, options.trace.stiffness()));
      } else {
        writer(input);
      }
    });
  } catch (const InputError& e) {
    throw InputError(options.source.string() + ": " + e.what());
  }
  writer.finish();
  report(options.trace.out, ticks, options.trace.header());
}

struct ToMcapOptions {
  fs::path trace, out;
};

void export_trace(const ToMcapOptions& options) {
  std::error_code failed;
  if (is_standard(options.trace) || fs::is_fifo(options.trace, failed))
    throw InputError(options.trace.string() + ": a pipe can be read only once, and this reads the trace twice; write it to a file first");
  const std::vector<std::uint8_t> whole = read_file(options.trace);
  const trace::Trace trace = trace::read_trace(options.trace);
  const bag::Bytes bytes = bag::trace_to_mcap(trace, options.trace.filename().string(), whole, files::short_version_text("isotouch"),
                                              [&](std::size_t tick) { return tick_json(trace, tick); });
  write_file(options.out, bytes.data(), bytes.size());
}

struct ToPacketsOptions {
  fs::path field;
  fs::path hand;
  fs::path out;
  std::string device = "libnifalcon";
};

/// What a device would have sent, and what its tick answers.
void make_packets(const ToPacketsOptions& options) {
  const field_file::OpenField field = field_file::open_field(options.field);
  const trace::Trace hand = trace::read_trace(options.hand, InputKind::kPosition);
  TraceHeader header = hand.header();
  header.device = options.device == "libnifalcon" ? libnifalcon_model() : martin_hillier_model();
  trace::Run run(field.view, header);
  trace::TraceWriter writer(options.out, run.header());
  motion::DeviceInHand device(header.device);
  for (std::size_t tick = 0; tick < hand.size(); ++tick) {
    const TraceRecord recorded = hand.record(tick);
    TraceRecord record = run.step(device(recorded.input));
    record.arrival_ns = recorded.arrival_ns;
    writer.append(record);
  }
  writer.finish();
  report(options.out, hand.size(), header);
  if (device.out_of_reach() > 0) {
    std::fprintf(stderr, "%llu ticks lay out of the device's reach; there it kept its last place\n",
                 static_cast<unsigned long long>(device.out_of_reach()));
  }
}

struct DiffOptions {
  fs::path a;
  fs::path b;
  bool json = false;
};

void compare_traces(const DiffOptions& options) {
  const trace::Trace a = trace::read_trace(options.a);
  const trace::Trace b = trace::read_trace(options.b);
  const std::optional<trace::Difference> difference = trace::first_difference(a, b);
  if (options.json) {
    nlohmann::ordered_json json{{"ticks", a.size()}, {"first_difference", nullptr}};
    if (difference) json["first_difference"] = {{"tick", difference->tick}, {"field", difference->field}};
    std::printf("%s\n", json.dump(2).c_str());
  } else if (!difference) {
    std::printf("equal: %zu ticks, every bit\n", a.size());
  }
  if (difference) {
    throw ComparisonFailed(options.a.string() + " and " + options.b.string() + " differ first at tick " + std::to_string(difference->tick) +
                           " in " + difference->field);
  }
}

void add_make(CLI::App& trace) {
  auto options = std::make_shared<MakeOptions>();
  CLI::App* command =
      trace.add_subcommand("make", "Make the motion of a hand: press slide tap corner graze stab leave, or tour (all of them)");
  command->add_option("KIND", options->motion.kind, "which")->required()->check(one_of(motion::motion_kinds()));
  command->add_option("FIELD", options->field, "the field that the hand follows; without one it moves through the whole workspace");
  command->add_option("--ticks", options->motion.ticks, "exact number of ticks; 0: one round of the motion")->capture_default_str();
  command->add_option("--seed", options->motion.seed, "seed of the places and speeds")->capture_default_str();
  command->add_option("--lost", options->lost_percent, "percentage of samples that do not arrive and are repeated")
      ->check(number_in(0.0, 50.0))
      ->capture_default_str();
  options->trace.add_to(*command);
  command->callback([options] { make_trace(*options); });
}

void add_import(CLI::App& trace) {
  auto options = std::make_shared<ImportOptions>();
  CLI::App* command = trace.add_subcommand(
      "import",
      "Turn a table of times and positions (with --forces: and forces) into a trace, resampled to the tick period by monotone cubics");
  command
      ->add_option("SOURCE", options->source,
                   "the table, whose first line names the columns; or a recording of ROS 2 or Foxglove (.mcap, .db3)")
      ->required();
  command->add_option("--topic", options->topic,
                      "topic of the positions in a recording (MCAP, .db3); by default the only topic that has positions");
  command->add_option("--force-topic", options->force_topic,
                      "with --forces, topic of the forces in a recording; by default the only topic that has forces");
  command->add_option("--columns", options->columns,
                      "t=NAME,x=NAME,y=NAME,z=NAME,fx=NAME,fy=NAME,fz=NAME (default t_s, x_mm, ..., fx_N, ...)");
  command->add_flag("--forces", options->forces,
                    "also read the forces on the hand, N, for isotouch scan; give the wall's stiffness with --stiffness");
  command->add_option("--time-unit", options->time_unit, "s ms us ns; default: the ending of the column's name");
  command->add_option("--length-unit", options->length_unit, "mm cm m in; default: the ending of x's name");
  command->add_flag("--centre", options->centre, "put the middle of the motion's box at the workspace's centre");
  command->add_option("--scale", options->scale, "then multiply")->capture_default_str();
  command->add_option("--offset", options->offset, "then move the motion by x,y,z mm")->delimiter(',')->expected(3);
  command
      ->add_option(
          "--into", options->into,
          "instead of --centre, --scale and --offset: centre the motion in this field's box and make its longest side as long as the box's")
      ->excludes("--centre")
      ->excludes("--scale")
      ->excludes("--offset");
  options->trace.add_to(*command);
  command->callback([options, command] {
    for (const CLI::Option* option : command->get_options()) {
      if (option->count() > 0 && !option->get_positional() && !option->check_lname("out")) options->given = option->get_name();
    }
    import_table(*options);
  });
}

void add_export_of_trace(CLI::App& trace) {
  auto options = std::make_shared<ToMcapOptions>();
  CLI::App* command =
      trace.add_subcommand("export", "Write a trace for Foxglove and ROS 2; isotouch trace import brings it back to the bit");
  command->add_option("TRACE", options->trace, "the trace (.trace)")->required();
  add_output(*command, "-o,--out", options->out, {&forms::kMcap}, "the file to write")->required();
  command->callback([options] { export_trace(*options); });
}

void add_to_packets(CLI::App& trace) {
  auto options = std::make_shared<ToPacketsOptions>();
  CLI::App* command = trace.add_subcommand(
      "to-packets", "Turn the positions of a hand into the packets of a device that the hand moves, and compute the tick's outputs");
  command->alias("wire");
  command->add_option("FIELD", options->field, "the field (.itf)")->required();
  command->add_option("HAND", options->hand, "the recorded positions (.trace)")->required();
  add_output(*command, "-o,--out", options->out, {&forms::kTrace}, "the trace to write")->required();
  command->add_option("--device", options->device, "the published model of the device")
      ->check(one_of({"libnifalcon", "martin-hillier"}))
      ->capture_default_str();
  command->callback([options] { make_packets(*options); });
}

void add_diff(CLI::App& trace) {
  auto options = std::make_shared<DiffOptions>();
  CLI::App* command =
      trace.add_subcommand("diff", "Find the first tick and value in which two recorded traces differ; exit code 3 if they do");
  command->add_option("A", options->a)->required();
  command->add_option("B", options->b)->required();
  command->add_flag("--json", options->json, "print one JSON object");
  command->callback([options] { compare_traces(*options); });
}

}  // namespace

void add_trace(CLI::App& app) {
  CLI::App* trace = app.add_subcommand("trace", "Make, import, show, derive and compare traces");
  trace->require_subcommand(1);
  add_make(*trace);
  add_import(*trace);
  add_export_of_trace(*trace);
  add_show(*trace);
  add_to_packets(*trace);
  add_mutate(*trace);
  add_diff(*trace);
  add_stop_latency(*trace);
}

}  // namespace isotouch::commands
