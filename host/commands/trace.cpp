/// isotouch trace: make a motion, import one, derive others, say where two recordings part.
#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "host/commands/commands.h"
#include "host/commands/quantities.h"
#include "host/commands/trace_mine.h"
#include "host/commands/trace_zero.h"
#include "host/error.h"
#include "host/evaluate/felt_surface.h"
#include "host/evaluate/motion.h"
#include "host/evaluate/motion_csv.h"
#include "host/evaluate/open_blob.h"
#include "host/evaluate/real.h"
#include "host/evaluate/replay.h"
#include "host/evaluate/resample.h"
#include "host/evaluate/trace_diff.h"
#include "host/evaluate/trace_file.h"
#include "host/evaluate/wire_hand.h"
#include "shared/device_model.h"
#include "shared/trace.h"

namespace isotouch::commands {

namespace {

namespace fs = std::filesystem;

/// What every new trace has in its header.
struct NewTrace {
  fs::path out;
  double period_ms = 1.0;
  double stiffness = 0.0;
  double damping = 0.0;
  double force_limit = evaluate::real(TickSettings{}.force_limit);
  std::uint32_t ramp_ticks = TickSettings{}.ramp_ticks;
  double friction = 0.0, friction_damping = 0.0, hand_damping = 0.0, passivity_damping = 0.0, weight = 0.0;
  double device_damping = 0.0;
  std::uint32_t delay_ticks = 0;

  void add_to(CLI::App& command) {
    command.add_option("-o,--out", out, "the trace to write")->required();
    command.add_option("--period", period_ms, "tick period, 0.1ms to 4ms")
        ->transform(quantity({{"ms", 1.0}, {"us", 0.001}, {"s", 1000.0}}, 0.1, 4.0))
        ->capture_default_str();
    command.add_option("--stiffness", stiffness, "N/mm; 0 takes the blob's")
        ->transform(quantity(kStiffness, 0.0, 100.0))
        ->capture_default_str();
    command.add_option("--damping", damping, "between proxy and hand, N·s/mm")->check(CLI::Range(0.0, 100.0))->capture_default_str();
    command.add_option("--force-limit", force_limit, "N")->check(CLI::Range(0.001, 100.0))->capture_default_str();
    command.add_option("--ramp", ramp_ticks, "ticks from no force to full where contact does not begin at rest")
        ->check(CLI::Range(0, 100000))
        ->capture_default_str();
    const double most = evaluate::real(kMostDamping), weight_limit = evaluate::real(kMostWeight);
    command.add_option("--friction", friction, "Coulomb's coefficient")->check(CLI::Range(0.0, evaluate::real(kMostFriction)));
    command.add_option("--friction-damping", friction_damping, "of a hand that slides, N·s/mm")->check(CLI::Range(0.0, most));
    command.add_option("--hand-damping", hand_damping, "of a hand that touches, N·s/mm")->check(CLI::Range(0.0, most));
    command.add_option("--passivity-damping", passivity_damping, "most that the passivity controller adds, N·s/mm")
        ->check(CLI::Range(0.0, most));
    command.add_option("--device-damping", device_damping, "that it counts on, N·s/mm")->check(CLI::Range(0.0, most));
    command.add_option("--delay", delay_ticks, "ticks until a force is felt, that it counts on")->check(CLI::Range(0U, kMostDelay));
    command.add_option("--weight", weight, "of the handle, held up, N")->check(CLI::Range(-weight_limit, weight_limit));
  }

  TraceHeader header() const {
    TraceHeader made;
    made.period_ns = static_cast<std::uint32_t>(period_ms * 1e6 + 0.5);
    made.settings = {evaluate::nearest<Stiffness>(stiffness), evaluate::nearest<Damping>(damping), evaluate::nearest<Newton>(force_limit),
                     ramp_ticks};
    made.settings.friction = evaluate::nearest<Ratio>(friction);
    made.settings.friction_damping = evaluate::nearest<Damping>(friction_damping);
    made.settings.hand_damping = evaluate::nearest<Damping>(hand_damping);
    made.settings.passivity = evaluate::nearest<Damping>(passivity_damping);
    made.settings.device_damping = evaluate::nearest<Damping>(device_damping);
    made.settings.weight = evaluate::nearest<Newton>(weight);
    made.settings.delay_ticks = delay_ticks;
    return made;
  }
};

/// Ticks as they come, one period apart.
class TickWriter {
 public:
  explicit TickWriter(const NewTrace& trace, std::uint32_t flags = 0)
      : header_(with_flags(trace.header(), flags)), writer_(trace.out, header_), chain_(header_, 0) {}
  void operator()(const TickInput& input) { writer_.append({input, {}, 0, header_.period_ns * tick_++}); }
  /// Only with the flag kHasOutputs.
  void operator()(const TickInput& input, const TickOutput& output) {
    writer_.append({input, output, chain_.extend(input, output), header_.period_ns * tick_++});
  }
  void finish() { writer_.finish(); }

 private:
  static TraceHeader with_flags(TraceHeader header, std::uint32_t flags) {
    header.flags = flags;
    return header;
  }
  TraceHeader header_;
  evaluate::TraceWriter writer_;
  Chain chain_;
  std::uint64_t tick_ = 0;
};

void report(const fs::path& file, std::uint64_t ticks, const TraceHeader& header) {
  std::fprintf(stderr, "%s: %llu ticks, %.3f s\n", file.string().c_str(), static_cast<unsigned long long>(ticks),
               static_cast<double>(ticks) * header.period_ns * 1e-9);
}

struct MakeOptions {
  NewTrace trace;
  evaluate::MotionOptions motion;
  double lost_percent = 0.0;
  fs::path blob;
};

void make_trace(const MakeOptions& options) {
  std::optional<evaluate::OpenBlob> blob;
  if (!options.blob.empty()) blob.emplace(evaluate::open_blob(options.blob));
  evaluate::MotionOptions motion = options.motion;
  motion.period_ns = options.trace.header().period_ns;
  motion.lost_share = options.lost_percent / 100;
  TickWriter writer(options.trace);
  const std::uint64_t ticks = evaluate::make_motion(blob ? &blob->view : nullptr, motion, [&](const TickInput& input) { writer(input); });
  writer.finish();
  report(options.trace.out, ticks, options.trace.header());
}

struct ImportOptions {
  NewTrace trace;
  fs::path csv;
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
void place(std::vector<evaluate::TimedPoint>& points, ImportOptions options) {
  Eigen::Vector3d low = points.front().position;
  Eigen::Vector3d high = low;
  for (const auto& point : points) {
    low = low.cwiseMin(point.position);
    high = high.cwiseMax(point.position);
  }
  const Eigen::Vector3d middle = options.centre || !options.into.empty() ? Eigen::Vector3d((low + high) / 2) : Eigen::Vector3d::Zero();
  Eigen::Vector3d offset(options.offset[0], options.offset[1], options.offset[2]);
  if (!options.into.empty()) {
    const evaluate::OpenBlob blob = evaluate::open_blob(options.into);
    const evaluate::FeltSurface object(blob.view);
    const double widest = (high - low).maxCoeff();
    if (!(widest > 0)) throw InputError(options.csv.string() + ": the motion stays at one place and cannot be scaled; leave --into out");
    options.scale = object.voxel_mm() * (*std::max_element(blob.view.size.begin(), blob.view.size.end()) - 1) / widest;
    offset = object.centre();
  }
  for (auto& point : points) point.position = options.scale * (point.position - middle) + offset;
}

/// What another device felt, as a tick puts it: the proxy where the stiffness says that the surface was.
TickOutput felt(const TickInput& input, const Eigen::Vector3d& force, double stiffness) {
  TickOutput output;
  output.force = evaluate::nearest<Newton>(force);
  output.status = output.force == Vec3<Newton>{} ? 0U : kContact;
  const Eigen::Vector3d hip = evaluate::real(input.hip);
  output.proxy = evaluate::nearest<Mm>(stiffness > 0 ? Eigen::Vector3d(hip + force / stiffness) : hip);
  return output;
}

void import_table(const ImportOptions& options) {
  evaluate::MotionColumns columns = evaluate::parse_columns(options.columns);
  columns.time_unit = options.time_unit;
  columns.length_unit = options.length_unit;
  columns.with_forces = options.forces;
  std::vector<evaluate::TimedPoint> points = evaluate::read_motion_csv(options.csv, columns);
  place(points, options);
  TickWriter writer(options.trace, options.forces ? trace_layout::kHasOutputs : 0);
  std::uint64_t ticks = 0;
  try {
    ticks = evaluate::resample(points, options.trace.header().period_ns, [&](const TickInput& input, const Eigen::Vector3d& force) {
      if (options.forces) {
        writer(input, felt(input, force, options.trace.stiffness));
      } else {
        writer(input);
      }
    });
  } catch (const InputError& e) {
    throw InputError(options.csv.string() + ": " + e.what());
  }
  writer.finish();
  report(options.trace.out, ticks, options.trace.header());
}

struct WireOptions {
  fs::path blob;
  fs::path hand;
  fs::path out;
  std::string device = "libnifalcon";
};

/// What a device would have sent, and what its tick answers.
void make_wire(const WireOptions& options) {
  const evaluate::OpenBlob blob = evaluate::open_blob(options.blob);
  const evaluate::Trace hand = evaluate::Trace::read(options.hand);
  const DeviceModel model = options.device == "libnifalcon" ? libnifalcon_model() : martin_hillier_model();
  DeviceTraceHeader header{hand.header(), model};
  header.run.flags = 0;
  evaluate::DeviceRun run(blob.view, header);
  evaluate::DeviceTraceWriter writer(options.out, run.header());
  evaluate::WireHand wire(model);
  for (std::size_t tick = 0; tick < hand.size(); ++tick) {
    const TraceRecord recorded = hand.record(tick);
    DeviceTraceRecord record = run.step(wire(recorded.input, 1));
    record.arrival_ns = recorded.arrival_ns;
    writer.append(record);
  }
  writer.finish();
  report(options.out, hand.size(), header.run);
  if (wire.out_of_reach() > 0) {
    std::fprintf(stderr, "%llu ticks lay out of the device's reach, the last place was kept\n",
                 static_cast<unsigned long long>(wire.out_of_reach()));
  }
}

struct DiffOptions {
  fs::path a;
  fs::path b;
  bool json = false;
};

template <class Format>
void compare_files(const DiffOptions& options) {
  const auto a = evaluate::TraceFile<Format>::read(options.a);
  const auto b = evaluate::TraceFile<Format>::read(options.b);
  const std::optional<evaluate::Difference> difference = evaluate::first_difference(a, b);
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

void compare_traces(const DiffOptions& options) {
  const bool at_the_wire = evaluate::trace_major(options.a) == evaluate::WireFormat::kMajor;
  at_the_wire ? compare_files<evaluate::WireFormat>(options) : compare_files<evaluate::HipFormat>(options);
}

void add_make(CLI::App& trace) {
  auto options = std::make_shared<MakeOptions>();
  CLI::App* command = trace.add_subcommand("make", "A motion: press slide tap corner graze stab leave, or tour (all of them)");
  command->add_option("KIND", options->motion.kind, "which")->required()->check(CLI::IsMember(evaluate::motion_kinds()));
  command->add_option("BLOB", options->blob, "the object it follows; without one it fills the workspace");
  command->add_option("--ticks", options->motion.ticks, "exactly so many; 0: one round of the motion")->capture_default_str();
  command->add_option("--seed", options->motion.seed, "other places, other speeds")->capture_default_str();
  command->add_option("--lost", options->lost_percent, "percentage of samples that do not arrive and are repeated")
      ->check(CLI::Range(0.0, 50.0))
      ->capture_default_str();
  options->trace.add_to(*command);
  command->callback([options] { make_trace(*options); });
}

void add_import(CLI::App& trace) {
  auto options = std::make_shared<ImportOptions>();
  CLI::App* command = trace.add_subcommand(
      "import", "A table of times and positions, with --forces also of forces, resampled to the tick period by monotone cubics");
  command->add_option("CSV", options->csv, "first line: the columns' names")->required();
  command->add_option("--columns", options->columns,
                      "t=NAME,x=NAME,y=NAME,z=NAME,fx=NAME,fy=NAME,fz=NAME (default t_s, x_mm, ..., fx_N, ...)");
  command->add_flag("--forces", options->forces, "also the forces on the hand, N, for isotouch scan; name the wall's --stiffness");
  command->add_option("--time-unit", options->time_unit, "s ms us ns; default: the ending of the column's name");
  command->add_option("--length-unit", options->length_unit, "mm cm m in; default: the ending of x's name");
  command->add_flag("--centre", options->centre, "put the middle of the motion's box at the workspace's centre");
  command->add_option("--scale", options->scale, "then multiply")->capture_default_str();
  command->add_option("--offset", options->offset, "then move by x,y,z mm")->delimiter(',')->expected(3);
  command->add_option("--into", options->into, "instead: centred in this blob's box, its longest side as long as the box's")
      ->excludes("--centre")
      ->excludes("--scale")
      ->excludes("--offset");
  options->trace.add_to(*command);
  command->callback([options] { import_table(*options); });
}

void add_wire(CLI::App& trace) {
  auto options = std::make_shared<WireOptions>();
  CLI::App* command = trace.add_subcommand("wire", "A recorded hand as a device's packets, with what the tick of that device answers");
  command->add_option("BLOB", options->blob, "the field (.itf)")->required();
  command->add_option("HAND", options->hand, "the recorded hand (.trace)")->required();
  command->add_option("-o,--out", options->out, "the trace to write")->required();
  command->add_option("--device", options->device, "the published numbers of the device")
      ->check(CLI::IsMember({"libnifalcon", "martin-hillier"}))
      ->capture_default_str();
  command->callback([options] { make_wire(*options); });
}

void add_diff(CLI::App& trace) {
  auto options = std::make_shared<DiffOptions>();
  CLI::App* command =
      trace.add_subcommand("diff", "The first tick and field in which two recorded traces differ; exit code 3 when they do");
  command->add_option("A", options->a)->required();
  command->add_option("B", options->b)->required();
  command->add_flag("--json", options->json, "print one JSON object");
  command->callback([options] { compare_traces(*options); });
}

}  // namespace

void add_trace(CLI::App& app) {
  CLI::App* trace = app.add_subcommand("trace", "Make, import, mine and compare recorded hands");
  trace->require_subcommand(1);
  add_make(*trace);
  add_import(*trace);
  add_wire(*trace);
  add_mine(*trace);
  add_diff(*trace);
  add_zero(*trace);
}

}  // namespace isotouch::commands
