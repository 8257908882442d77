/// isotouch replay: a trace through the core, and whether it answers as recorded.
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "host/board_commands/commands.h"
#include "host/board_commands/output.h"
#include "host/board_commands/print_field.h"
#include "host/field_file/open_field.h"
#include "host/to_double.h"
#include "host/trace/hash_text.h"
#include "host/trace/replay.h"
#include "host/trace/trace_file.h"
#include "shared/certificate.h"

namespace isotouch::commands {

namespace {

struct Options {
  std::filesystem::path field;
  std::filesystem::path trace;
  std::filesystem::path out;
  bool check = false;
  bool json = false;
  std::string key;  ///< only this value of the JSON object
};

nlohmann::ordered_json to_json(const trace::ReplayReport& report) {
  nlohmann::ordered_json json{{"ticks", report.ticks}, {"seconds", report.seconds}, {"hash", trace::hash_text(report.hash)}};
  json["first_difference"] = nullptr;
  if (report.first_difference)
    json["first_difference"] = {{"tick", report.first_difference->tick}, {"field", report.first_difference->field}};
  return json;
}

void print_text(std::FILE* to, const trace::ReplayReport& report, bool checked) {
  std::fprintf(to, "ticks        %llu\n", static_cast<unsigned long long>(report.ticks));
  std::fprintf(to, "seconds      %.3f\n", report.seconds);
  if (report.seconds > 0) std::fprintf(to, "ticks/s      %.0f\n", static_cast<double>(report.ticks) / report.seconds);
  std::fprintf(to, "replay hash  %s\n", trace::hash_text(report.hash).c_str());
  if (checked && !report.first_difference) std::fprintf(to, "check        equal to the recorded outputs, every bit\n");
}

/// Says so where this field with these settings would feed energy into the hand, on the device that its certificate assumes.
void warn(const Options& options, const FieldView& field, const TraceHeader& run) {
  Loop loop = assumed_loop(field);
  if (loop.damping == Damping{}) return;
  loop.period_ns = run.period_ns;
  const CertificateCheck check = check_certificate(field, loop, run.settings.stiffness);
  if (check.accepted) return;
  std::fprintf(stderr, "isotouch: %s: %s", options.field.string().c_str(), describe(check.error));
  if (check.error == Error::kTooStiff) {
    std::fprintf(stderr, "; with this trace's period up to %.3g N/mm is safe on the device that `info` assumes",
                 to_double(check.stiffness));
  }
  std::fprintf(stderr, "\n");
}

void run(const Options& options) {
  const field_file::OpenField field = field_file::open_field(options.field);
  const trace::Trace trace = trace::read_trace(options.trace);
  warn(options, field.view, trace.header());
  std::optional<trace::TraceWriter> writer;
  if (!options.out.empty()) writer.emplace(options.out, trace::replay_header(field.view, trace.header()));
  const trace::ReplayReport report = trace::replay(field.view, trace, options.check, writer ? &*writer : nullptr);
  if (writer) writer->finish();
  if (!options.key.empty()) {
    print_field(to_json(report), options.key);
  } else if (options.json) {
    std::printf("%s\n", to_json(report).dump(2).c_str());
  } else {
    print_text(text_stream(options.out), report, options.check);
  }
  if (report.first_difference) {
    throw ComparisonFailed(options.trace.string() + ": differs first at tick " + std::to_string(report.first_difference->tick) + " in " +
                           report.first_difference->field);
  }
}

}  // namespace

void add_replay(CLI::App& app) {
  auto options = std::make_shared<Options>();
  CLI::App* command =
      app.add_subcommand("replay", "Compute a trace's outputs again; the same field and inputs give the same hash on every machine");
  command->add_option("FIELD", options->field, "the field (.itf)")->required();
  command->add_option("TRACE", options->trace, "the recorded hand or device (.trace)")->required();
  command->add_flag("--check", options->check, "compare with the recorded outputs to the bit; exit code 3 when they differ");
  add_output(*command, "-o,--out", options->out, {&forms::kTrace}, "write the trace with this run's outputs");
  command->add_flag("--json", options->json, "print one JSON object");
  command->add_option("--field", options->key, "print only the value with this key of the JSON object, such as hash");
  command->callback([options] {
    require_apart(options->out, options->json || !options->key.empty());
    run(*options);
  });
}

}  // namespace isotouch::commands
