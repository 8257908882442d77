/// isotouch trace: make a motion, export one, derive others, find where two traces differ first.
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <system_error>
#include <vector>

#include "host/bag/trace_to_mcap.h"
#include "host/board_commands/choice.h"
#include "host/board_commands/number_in.h"
#include "host/board_commands/output.h"
#include "host/board_commands/print_json.h"
#include "host/board_commands/trace_show.h"
#include "host/board_commands/trace_stop_latency.h"
#include "host/commands/commands.h"
#include "host/commands/new_trace.h"
#include "host/commands/trace_import.h"
#include "host/commands/trace_mutate.h"
#include "host/error.h"
#include "host/field_file/open_field.h"
#include "host/files/whole_file.h"
#include "host/motion/device_in_hand.h"
#include "host/motion/motion.h"
#include "host/trace/recorded_patches.h"
#include "host/trace/replay.h"
#include "host/trace/trace_diff.h"
#include "host/trace/trace_file.h"
#include "shared/device_model.h"
#include "shared/files/version_text.h"
#include "shared/tick_times.h"
#include "shared/trace.h"

namespace isotouch::commands {

namespace {

namespace fs = std::filesystem;

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

struct ToMcapOptions {
  fs::path trace, out;
};

void export_trace(const ToMcapOptions& options) {
  std::error_code failed;
  if (is_standard(options.trace) || fs::is_fifo(options.trace, failed))
    throw InputError(options.trace.string() + ": a pipe can be read only once, and this reads the trace twice; write it to a file first");
  const std::vector<std::uint8_t> whole = read_file(options.trace);
  const trace::Trace trace = trace::read_trace(options.trace);
  const bag::Bytes bytes =
      bag::trace_to_mcap(trace, options.trace.filename().string(), whole, trace::patch_bytes(trace), files::short_version_text("isotouch"),
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
  header.device = at_period(options.device == "libnifalcon" ? libnifalcon_model() : martin_hillier_model(), header.period_ns);
  const std::optional<std::vector<std::uint8_t>> patch_bytes = trace::patches_for(options.out, hand);
  const std::optional<trace::RecordedPatches> patches = trace::read_patches(hand, field.view);
  trace::Run run(field.view, header, patches ? &*patches : nullptr);
  trace::TraceWriter writer(options.out, run.header());
  motion::DeviceInHand device(header.device);
  for (std::size_t tick = 0; tick < hand.size(); ++tick) {
    const TraceRecord recorded = hand.record(tick);
    TraceRecord record = run.step(device(recorded.input));
    record.arrival_ns = recorded.arrival_ns;
    writer.append(record);
  }
  trace::finish_with_patches(options.out, patch_bytes, [&] { writer.finish(); });
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
  const trace::Trace a = trace::read_trace(options.a, trace::Damaged::kReport);
  const trace::Trace b = trace::read_trace(options.b, trace::Damaged::kReport);
  const std::optional<trace::Difference> difference = trace::first_difference(a, b);
  if (options.json) {
    nlohmann::ordered_json json{{"ticks", a.size()}, {"first_difference", nullptr}};
    if (difference) json["first_difference"] = {{"tick", difference->tick}, {"field", difference->field}};
    print_json(json);
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
  command->add_option("--ticks", options->motion.ticks, "exact number of ticks; 0: one round of the motion")
      ->check(whole_number_in(0, motion::kMaxTicks))
      ->capture_default_str();
  command->add_option("--seed", options->motion.seed, "seed of the places and speeds")->capture_default_str();
  command->add_option("--lost", options->lost_percent, "percentage of samples that do not arrive and are repeated")
      ->check(number_in(0.0, 50.0))
      ->capture_default_str();
  options->trace.add_to(*command);
  command->callback([options] { make_trace(*options); });
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
  command->add_option("A", options->a, "a recorded trace (.trace)")->required();
  command->add_option("B", options->b, "the trace to compare it with (.trace)")->required();
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
