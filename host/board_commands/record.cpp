/// isotouch record: what a running controller does, as a trace that replays.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <span>
#include <string>

#include "host/board_commands/commands.h"
#include "host/board_commands/controller_options.h"
#include "host/board_commands/interruption.h"
#include "host/board_commands/number_in.h"
#include "host/board_commands/output.h"
#include "host/board_commands/print_json.h"
#include "host/error.h"
#include "host/link/controller.h"
#include "host/link/status.h"
#include "host/trace/hash_text.h"
#include "host/trace/trace_file.h"
#include "shared/trace.h"

namespace isotouch::commands {

namespace {

struct RecordOptions {
  std::string to;
  std::filesystem::path out;
  double seconds = 10;
  bool json = false;
};

void run(const RecordOptions& options) {
  using trace_layout::kRecordBytes;
  link::Controller controller(options.to);
  const double period = controller.welcome().period_ns / 1e9;
  const auto ticks = static_cast<std::uint64_t>(std::max(1.0, std::round(options.seconds / std::max(period, 1e-4))));
  const auto refuse = [&](const char* what) { return InputError(options.to + ": " + what + "; install the same release on both sides"); };
  if (const protocol::StatusReport status = controller.status(); status.faults != 0)
    std::fprintf(stderr, "%s: %s: the recording will hold no force; the state is %s\n", link::tool_name().c_str(), options.to.c_str(),
                 link::sentence(status, controller.device()).c_str());
  std::optional<trace::TraceWriter> writer;
  std::uint64_t taken = 0;
  const Interruption interruption;
  std::string ended = controller.record(
      ticks,
      [&](std::span<const std::uint8_t> bytes) {
        const Result<TraceHeader> header = decode_header(bytes, bytes.size());
        if (!header) throw refuse("the recording's header cannot be read");
        writer.emplace(options.out, *header, files::Leftover::kRefuse);
      },
      [&](std::span<const std::uint8_t> bytes) {
        if (bytes.size() != kRecordBytes) throw refuse("the recording has another format");
        const Result<TraceRecord> record = decode_record(bytes.first<kRecordBytes>());
        if (!record) throw refuse("a record of the recording cannot be read");
        writer->append(*record);
        ++taken;
      },
      [&] { return interruption.has_come() || (writer && writer->is_full()); });
  if (taken == 0 && !(writer && writer->is_full())) throw InputError(options.to + ": interrupted before a tick came; nothing was recorded");
  const trace::TraceWriter::Kept kept = writer->finish_with_what_fits();
  if (kept.records < taken) ended = "the disk is full; free space on it";
  if (options.json) {
    const nlohmann::ordered_json json{{"ticks", kept.records}, {"hash", trace::hash_text(kept.chain)}};
    print_json(json);
  } else {
    std::fprintf(text_stream(options.out), "%llu ticks, replay hash %s\n", static_cast<unsigned long long>(kept.records),
                 trace::hash_text(kept.chain).c_str());
  }
  if (!ended.empty())
    throw EndedEarly(ended + "; " + options.out.string() + " holds the " + std::to_string(kept.records) + " ticks before");
}

}  // namespace

void add_record(CLI::App& app) {
  auto options = std::make_shared<RecordOptions>();
  CLI::App* command = app.add_subcommand(
      "record", "Record the ticks of a running controller as a trace that replays to the bit; Ctrl-C ends the recording and keeps it");
  add_address(*command, options->to);
  add_output(*command, "-o,--out", options->out, {&forms::kTrace}, "the trace to write")->required();
  command->add_option("--seconds", options->seconds, "how long at most")->check(number_in(0.001, 86400.0))->capture_default_str();
  command->add_flag("--json", options->json, "print one JSON object");
  command->callback([options] {
    require_apart(options->out, options->json);
    run(*options);
  });
}

}  // namespace isotouch::commands
