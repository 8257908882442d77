#include "host/commands/trace_mine.h"

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "host/error.h"
#include "host/evaluate/mine_hand.h"
#include "host/evaluate/mine_wire.h"
#include "host/evaluate/open_blob.h"
#include "host/evaluate/replay.h"
#include "host/evaluate/trace_file.h"

namespace isotouch::commands {

namespace {

namespace fs = std::filesystem;

struct MineOptions {
  std::string kind;
  fs::path blob;
  fs::path trace;
  fs::path out;
  std::uint64_t seed = 1;
};

bool is_one_of(const std::vector<std::string>& names, const std::string& name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

/// Inputs alone, as `trace make` writes them.
std::uint64_t mine_positions(const MineOptions& options, const BlobView& field) {
  const evaluate::Trace recorded = evaluate::Trace::read(options.trace);
  std::vector<TickInput> hand(recorded.size());
  for (std::size_t tick = 0; tick < hand.size(); ++tick) hand[tick] = recorded.record(tick).input;
  TraceHeader header = recorded.header();
  header.flags = 0;
  header.blob_hash = 0;
  evaluate::TraceWriter writer(options.out, header);
  std::uint64_t tick = 0;
  evaluate::mine_hand(hand, field, {options.kind, options.seed, header.period_ns}, [&](const TickInput& input) {
    writer.append({input, {}, 0, header.period_ns * tick++});
  });
  writer.finish();
  return tick;
}

/// With what the tick of that device answers, as `trace wire` writes it.
std::uint64_t mine_packets(const MineOptions& options, const BlobView& field) {
  const evaluate::DeviceTrace recorded = evaluate::DeviceTrace::read(options.trace);
  evaluate::WireRecording recording{recorded.header(), {}};
  for (std::size_t tick = 0; tick < recorded.size(); ++tick) recording.inputs.push_back(recorded.record(tick).input);
  const evaluate::WireRecording mined = evaluate::mine_wire(recording, options.kind, options.seed);
  evaluate::DeviceRun run(field, mined.header);
  evaluate::DeviceTraceWriter writer(options.out, run.header());
  std::uint64_t tick = 0;
  for (const DeviceInput& input : mined.inputs) {
    DeviceTraceRecord record = run.step(input);
    record.arrival_ns = mined.header.run.period_ns * tick++;
    writer.append(record);
  }
  writer.finish();
  return tick;
}

void mine(const MineOptions& options) {
  const evaluate::OpenBlob blob = evaluate::open_blob(options.blob);
  const bool at_the_wire = evaluate::trace_major(options.trace) == evaluate::WireFormat::kMajor;
  if (at_the_wire != is_one_of(evaluate::mined_wires(), options.kind)) {
    throw InputError(options.trace.string() + (at_the_wire ? " is a recording at the wire, but '" + options.kind +
                                                                 "' is mined from a hand; mine the hand first, then isotouch trace wire"
                                                           : " is a recorded hand, but '" + options.kind +
                                                                 "' is mined at the wire; make it one with isotouch trace wire"));
  }
  std::uint64_t ticks = 0;
  try {
    ticks = at_the_wire ? mine_packets(options, blob.view) : mine_positions(options, blob.view);
  } catch (const InputError& e) {
    throw InputError(options.trace.string() + ": " + e.what());
  }
  std::fprintf(stderr, "%s: %llu ticks\n", options.out.string().c_str(), static_cast<unsigned long long>(ticks));
}

}  // namespace

void add_mine(CLI::App& trace) {
  auto options = std::make_shared<MineOptions>();
  CLI::App* command = trace.add_subcommand(
      "mine", "A nasty recording out of a harmless one: of hands " + [] {
        std::string names;
        for (const std::string& kind : evaluate::mined_hands()) names += kind + " ";
        names += "(at HIP positions), at the wire";
        for (const std::string& kind : evaluate::mined_wires()) names += " " + kind;
        return names;
      }());
  std::vector<std::string> kinds = evaluate::mined_hands();
  kinds.insert(kinds.end(), evaluate::mined_wires().begin(), evaluate::mined_wires().end());
  command->add_option("KIND", options->kind, "which")->required()->check(CLI::IsMember(kinds));
  command->add_option("BLOB", options->blob, "the object that was or will be touched (.itf)")->required();
  command->add_option("TRACE", options->trace, "the recording (.trace)")->required();
  command->add_option("-o,--out", options->out, "the trace to write")->required();
  command->add_option("--seed", options->seed, "draws otherwise")->capture_default_str();
  command->callback([options] { mine(*options); });
}

}  // namespace isotouch::commands
