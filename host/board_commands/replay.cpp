/// isotouch replay: a trace through the core, and whether it answers as recorded; or through another renderer, and how that differs.
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "host/board_commands/choice.h"
#include "host/board_commands/commands.h"
#include "host/board_commands/output.h"
#include "host/board_commands/print_json.h"
#include "host/board_commands/print_key.h"
#include "host/board_commands/quantiles_json.h"
#include "host/error.h"
#include "host/field_file/open_field.h"
#include "host/link/words.h"
#include "host/to_double.h"
#include "host/trace/hash_text.h"
#include "host/trace/recorded_patches.h"
#include "host/trace/rendering_difference.h"
#include "host/trace/replay.h"
#include "host/trace/trace_file.h"
#include "shared/certificate.h"

namespace isotouch::commands {

namespace {

constexpr const char* kField = "field";
constexpr const char* kPublished = "published";
constexpr const char* kGodObject = "god-object";

struct ReplayOptions {
  std::filesystem::path field;
  std::filesystem::path trace;
  std::string patches;   ///< empty: beside the trace
  std::string renderer;  ///< empty: the core, and nothing is measured
  std::filesystem::path mesh;
  MakeGodObject make_god_object;
  std::filesystem::path out;
  bool check = false;
  bool json = false;
  std::string key;  ///< only this value of the JSON object
};

/// A run, and how it differs from the recording where that was asked for.
struct Replayed {
  trace::ReplayReport report;
  std::optional<trace::RenderingFigures> difference;
};

nlohmann::ordered_json to_json(const trace::RenderingErrors& errors) {
  return {{"force_n", quantiles_json(errors.force_n)},
          {"direction_deg", quantiles_json(errors.direction_deg)},
          {"proxy_mm", quantiles_json(errors.proxy_mm)}};
}

nlohmann::ordered_json to_json(const trace::RenderingFigures& figures) {
  nlohmann::ordered_json json = to_json(figures.all);
  json["contact_differs"] = figures.contact_differs;
  json["touching"] = figures.touching;
  json["shallow"] = to_json(figures.shallow);
  return json;
}

nlohmann::ordered_json to_json(const ReplayOptions& options, const Replayed& replayed) {
  const trace::ReplayReport& report = replayed.report;
  nlohmann::ordered_json json{{"ticks", report.ticks}, {"seconds", report.seconds}, {"hash", trace::hash_text(report.hash)}};
  json["first_difference"] = nullptr;
  if (report.first_difference)
    json["first_difference"] = {{"tick", report.first_difference->tick}, {"field", report.first_difference->field}};
  if (options.renderer.empty()) return json;
  json["renderer"] = options.renderer;
  json["difference"] = nullptr;
  if (replayed.difference) json["difference"] = to_json(*replayed.difference);
  return json;
}

void print_text(std::FILE* to, const trace::ReplayReport& report, bool checked) {
  std::fprintf(to, "ticks        %llu\n", static_cast<unsigned long long>(report.ticks));
  std::fprintf(to, "seconds      %.3f\n", report.seconds);
  if (report.seconds > 0) std::fprintf(to, "ticks/s      %.0f\n", static_cast<double>(report.ticks) / report.seconds);
  std::fprintf(to, "replay hash  %s\n", trace::hash_text(report.hash).c_str());
  if (checked && !report.first_difference) std::fprintf(to, "check        equal to the recorded outputs, every bit\n");
}

void print_row(std::FILE* to, const char* name, const Quantiles& of) {
  if (of.count == 0) {
    std::fprintf(to, "%-14s %8zu  no tick was compared\n", name, of.count);
    return;
  }
  std::fprintf(to, "%-14s %8zu %9.4f %9.4f %9.4f %9.4f\n", name, of.count, of.median, of.p95, of.p99, of.max);
}

void print_rows(std::FILE* to, const trace::RenderingErrors& errors) {
  print_row(to, "force, N", errors.force_n);
  print_row(to, "direction, deg", errors.direction_deg);
  print_row(to, "proxy, mm", errors.proxy_mm);
}

void print_text(std::FILE* to, const std::string& renderer, const trace::RenderingFigures& figures) {
  std::fprintf(to, "\n%s beside the recording: %zu of %zu ticks touch the object; in %zu of these only one of the two touches\n",
               renderer.c_str(), figures.touching, figures.ticks, figures.contact_differs);
  std::fprintf(to, "%-14s %8s %9s %9s %9s %9s\n", "", "ticks", "median", "p95", "p99", "max");
  print_rows(to, figures.all);
  std::fprintf(to, "of a hand up to %.0f mm deep\n", trace::kShallowMm);
  print_rows(to, figures.shallow);
}

/// The stiffest that the run sets.
///
/// returns   0: it is the field's all the time
Stiffness stiffest(const trace::Trace& run, const FieldView& field) {
  const Stiffness first = run.header().settings.stiffness;
  Stiffness most = first == Stiffness{} ? field.stiffness : first;
  bool is_set = first != Stiffness{};
  for (std::size_t tick = 0; run.kind() == InputKind::kPacket && tick < run.size(); ++tick) {
    const SettingChange change = run.record(tick).input.change;
    if (change.setting == TickSetting::kStiffness && change.raw > most.raw()) most = Stiffness::from_raw(change.raw), is_set = true;
  }
  return is_set ? most : Stiffness{};
}

/// Says so where this field with these settings would feed energy into the hand, on the device that its certificate assumes.
void warn(const ReplayOptions& options, const FieldView& field, const trace::Trace& run) {
  Loop loop = assumed_loop(field);
  if (loop.damping == Damping{}) return;
  loop.period_ns = run.header().period_ns;
  const CertificateCheck check = check_certificate(field, loop, stiffest(run, field));
  if (check.accepted) return;
  std::fprintf(stderr, "%s: %s: %s", link::tool_name().c_str(), options.field.string().c_str(), describe(check.error));
  if (check.error == Error::kTooStiff) {
    std::fprintf(stderr, "; with this trace's period up to %.3g N/mm is safe on the device that `info` assumes",
                 to_double(check.stiffness));
  }
  std::fprintf(stderr, "\n");
}

/// What can be refused before anything is computed.
void check_renderer(const ReplayOptions& options, const FieldView& field, const trace::Trace& trace) {
  if (options.renderer == kPublished && field.method != Method::kPublished) {
    throw InputError(options.field.string() +
                     ": the default method made it, and the paper's renderer needs a field of the paper's levels; build one with: "
                     "isotouch build CLOUD --method published -o FIELD.itf");
  }
  if (options.renderer == kGodObject && options.mesh.empty())
    throw UsageError("--renderer god-object needs the true surface of the object; name its closed mesh with --mesh");
  if (options.renderer != kGodObject && !options.mesh.empty())
    throw UsageError("--mesh is the surface for the god-object; add --renderer god-object");
  if (options.renderer == kGodObject && options.check) {
    throw UsageError(
        "--check compares every bit with the controller's own answers, which a god-object does not give; leave it out to read the "
        "differences");
  }
  if (options.renderer == kGodObject && !options.out.empty() && trace.kind() == InputKind::kPacket) {
    throw UsageError(options.trace.string() +
                     ": it holds packets of a device; a trace of packets needs motor commands, and a god-object gives none; leave -o out");
  }
  if (!options.renderer.empty() && options.out.empty() && !trace.header().has_outputs) {
    throw InputError(options.trace.string() +
                     ": it holds inputs only, so there is nothing to compare the renderer with; replay it with -o first");
  }
}

Replayed replayed(const ReplayOptions& options, const FieldView& field, const trace::Trace& trace) {
  std::optional<std::vector<std::uint8_t>> patches;
  if (!options.out.empty()) patches = trace::patches_for(options.out, trace);
  std::unique_ptr<trace::Renderer> god_object;
  if (options.renderer == kGodObject) god_object = options.make_god_object(field, options.mesh, trace);
  std::optional<trace::TraceWriter> writer;
  if (!options.out.empty()) writer.emplace(options.out, god_object ? god_object->header() : trace::replay_header(field, trace.header()));
  trace::TraceWriter* const out = writer ? &*writer : nullptr;
  trace::RenderingDifference difference;
  const bool compares = !options.renderer.empty() && trace.header().has_outputs;
  trace::RenderingDifference* const beside = compares ? &difference : nullptr;

  Replayed replayed;
  replayed.report = god_object ? trace::replay(*god_object, trace, out, beside) : trace::replay(field, trace, options.check, out, beside);
  if (compares) {
    replayed.difference = difference.figures();
    if (replayed.difference->touching == 0) {
      throw InputError(options.trace.string() + ": the hand touches the object neither in the recording nor with --renderer " +
                       options.renderer + ", so there is nothing to compare; replay a recording with contact");
    }
  }
  if (writer) trace::finish_with_patches(options.out, patches, [&] { writer->finish(); });
  return replayed;
}

void run(const ReplayOptions& options) {
  const field_file::OpenField field = field_file::open_field(options.field);
  const bool looks_at_damage = options.check && options.out.empty();  // a new trace would look as if nothing had been changed
  trace::Trace trace = trace::read_trace(options.trace, looks_at_damage ? trace::Damaged::kReport : trace::Damaged::kRefuse);
  trace.set_patches(options.patches);
  check_renderer(options, field.view, trace);
  warn(options, field.view, trace);
  const Replayed done = replayed(options, field.view, trace);
  const trace::ReplayReport& report = done.report;
  if (!options.key.empty()) {
    print_key(to_json(options, done), options.key);
  } else if (options.json) {
    print_json(to_json(options, done));
  } else {
    print_text(text_stream(options.out), report, options.check);
    if (done.difference) print_text(text_stream(options.out), options.renderer, *done.difference);
  }
  if (report.first_difference) {
    throw ComparisonFailed(options.trace.string() + ": differs first at tick " + std::to_string(report.first_difference->tick) + " in " +
                           report.first_difference->field);
  }
}

}  // namespace

void add_replay(CLI::App& app, const MakeGodObject& god_object) {
  auto options = std::make_shared<ReplayOptions>();
  options->make_god_object = god_object;
  std::vector<std::string> renderers = {kField, kPublished};
  if (god_object) renderers.emplace_back(kGodObject);
  CLI::App* command =
      app.add_subcommand("replay", "Compute a trace's outputs again; the same field and inputs give the same hash on every machine");
  command->add_option("FIELD", options->field, "the field (.itf)")->required();
  command->add_option("TRACE", options->trace, "the recorded hand or device (.trace)")->required();
  command->add_option("PATCHES", options->patches,
                      "the patches of a field that was patched meanwhile; by default TRACE's, in the file beside it");
  command
      ->add_option("--renderer", options->renderer,
                   god_object
                       ? "render the recorded hand again and print how forces and proxies differ from the recorded ones: field (the "
                         "controller on FIELD), published (the paper's proxy; FIELD must be built with --method published) or god-object "
                         "(on the mesh that --mesh names)"
                       : "render the recorded hand again and print how forces and proxies differ from the recorded ones: field (the "
                         "controller on FIELD) or published (the paper's proxy; FIELD must be built with --method published)")
      ->check(one_of(renderers));
  if (god_object) {
    command->add_option("--mesh", options->mesh,
                        "for --renderer god-object: the closed true surface in the frame of FIELD's cloud (PLY, OBJ or STL)");
  }
  command->add_flag("--check", options->check, "compare with the recorded outputs to the bit; exit code 3 when they differ");
  add_output(*command, "-o,--out", options->out, {&forms::kTrace}, "write the trace with this run's outputs");
  command->add_flag("--json", options->json, "print one JSON object");
  command->add_option("--key", options->key, "print only the value with this key of the JSON object, such as hash");
  command->callback([options] {
    require_apart(options->out, options->json);
    require_apart(options->out, !options->key.empty(), "--key");
    run(*options);
  });
}

}  // namespace isotouch::commands
