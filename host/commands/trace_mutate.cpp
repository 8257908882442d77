/// isotouch trace mutate: hostile traces derived from recorded or made ones.
#include "host/commands/trace_mutate.h"

#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "host/board_commands/choice.h"
#include "host/board_commands/output.h"
#include "host/error.h"
#include "host/field_file/open_field.h"
#include "host/motion/mutate.h"
#include "host/trace/recorded_patches.h"
#include "host/trace/replay.h"
#include "host/trace/trace_file.h"

namespace isotouch::commands {

namespace {

namespace fs = std::filesystem;

struct TraceMutateOptions {
  std::string name;
  fs::path field;
  fs::path trace;
  fs::path out;
  std::uint64_t seed = 1;
};

motion::Recording read_inputs(const TraceMutateOptions& options, const trace::Trace& trace) {
  const motion::Mutation& mutation = *motion::find_mutation(options.name);
  if (trace.kind() != mutation.of) {
    throw InputError(options.trace.string() +
                     (mutation.of == InputKind::kPacket
                          ? ": holds positions of a hand, but '" + options.name +
                                "' changes the packets of a device; make some with isotouch trace to-packets"
                          : ": holds the packets of a device, but '" + options.name +
                                "' changes positions; mutate the positions first, then isotouch trace to-packets"));
  }
  motion::Recording recording{trace.header(), {}};
  for (std::size_t tick = 0; tick < trace.size(); ++tick) recording.inputs.push_back(trace.record(tick).input);
  return recording;
}

/// Positions alone, as `trace make` writes them. The patches of their field stand beside them, too.
void write_positions(const fs::path& out, const motion::Recording& recording, const trace::Trace& recorded) {
  const std::optional<std::vector<std::uint8_t>> patches = trace::patches_for(out, recorded);
  TraceHeader header = recording.header;
  header.has_outputs = false;
  header.field_hash = 0;
  trace::TraceWriter writer(out, header);
  std::uint64_t tick = 0;
  for (const Input& input : recording.inputs) writer.append({input, {}, 0, header.period_ns * tick++});
  trace::finish_with_patches(out, patches, [&] { writer.finish(); });
}

/// Packets with what the tick of that device answers, as `trace to-packets` writes them. The patches of their field stand beside them, too.
void write_packets(const fs::path& out, const motion::Recording& recording, const FieldView& field, const trace::Trace& recorded) {
  const std::optional<std::vector<std::uint8_t>> patch_bytes = trace::patches_for(out, recorded);
  const std::optional<trace::RecordedPatches> patches = trace::read_patches(recorded, field);
  trace::Run run(field, recording.header, patches ? &*patches : nullptr);
  trace::TraceWriter writer(out, run.header());
  std::uint64_t tick = 0;
  for (const Input& input : recording.inputs) {
    TraceRecord record = run.step(input);
    record.arrival_ns = recording.header.period_ns * tick++;
    writer.append(record);
  }
  trace::finish_with_patches(out, patch_bytes, [&] { writer.finish(); });
}

void run(const TraceMutateOptions& options) {
  const field_file::OpenField field = field_file::open_field(options.field);
  const trace::Trace trace = trace::read_trace(options.trace);
  const motion::Recording recording = read_inputs(options, trace);
  motion::Recording mutated;
  try {
    mutated = motion::mutate(recording, options.name, field.view, options.seed);
  } catch (const InputError& e) {
    throw InputError(options.trace.string() + ": " + e.what());
  }
  motion::find_mutation(options.name)->of == InputKind::kPacket ? write_packets(options.out, mutated, field.view, trace)
                                                                : write_positions(options.out, mutated, trace);
  std::fprintf(stderr, "%s: %zu ticks\n", options.out.string().c_str(), mutated.inputs.size());
}

/// One line for each, those of positions first.
std::string list_of_mutations() {
  std::string list = "The mutations:";
  for (const motion::Mutation& mutation : motion::mutations()) {
    list += "\n  " + std::string(mutation.name) + std::string(10 - mutation.name.size(), ' ') +
            (mutation.of == InputKind::kPacket ? "packets    " : "positions  ") + std::string(mutation.meaning);
  }
  return list;
}

}  // namespace

void add_mutate(CLI::App& trace) {
  auto options = std::make_shared<TraceMutateOptions>();
  CLI::App* command = trace.add_subcommand("mutate", "Make a difficult trace out of a harmless one");
  command->footer(list_of_mutations());
  std::vector<std::string> names;
  for (const motion::Mutation& mutation : motion::mutations()) names.emplace_back(mutation.name);
  command->add_option("MUTATION", options->name, "the change to make")->required()->check(one_of(names));
  command->add_option("FIELD", options->field, "the field that was or will be touched (.itf)")->required();
  command->add_option("TRACE", options->trace, "the trace to derive it from (.trace)")->required();
  add_output(*command, "-o,--out", options->out, {&forms::kTrace}, "the trace to write")->required();
  command->add_option("--seed", options->seed, "seed of the random numbers")->capture_default_str();
  command->callback([options] { run(*options); });
}

}  // namespace isotouch::commands
