/// isotouch qualify: is a board fit? Its ticks, its timers, its temperature and what its worst ticks waited for, in one report with a verdict.
#include <cstdint>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <system_error>
#include <vector>

#include "host/board_commands/controller_options.h"
#include "host/board_commands/interruption.h"
#include "host/board_commands/number_in.h"
#include "host/board_commands/output.h"
#include "host/commands/commands.h"
#include "host/error.h"
#include "host/files/json_text.h"
#include "host/files/whole_file.h"
#include "host/qualify/measure.h"
#include "host/qualify/report.h"
#include "host/view/caption.h"

namespace isotouch::commands {

namespace {

struct QualifyOptions {
  std::string to;
  qualify::Wish wish;
  qualify::Limits limits;
  std::filesystem::path page, json;
};

void print(std::FILE* to, const qualify::Figures& figures, const std::vector<qualify::Judgement>& judgements) {
  for (const qualify::Judgement& j : judgements) {
    const bool known = j.outcome != qualify::Judgement::Outcome::kNotMeasured;
    std::fprintf(to, "%-26s%10s %-6s limit %s: %s\n", j.what.c_str(), known ? view::significant(j.value, 3).c_str() : "", j.unit.c_str(),
                 view::significant(j.limit, 3).c_str(), qualify::in_words(j.outcome));
  }
  if (!figures.practice.empty())
    std::fprintf(to, "settings of the board that affect timing (they explain the figures above; the verdict does not depend on them):\n");
  for (const qualify::Finding& f : figures.practice) {
    std::fprintf(to, "%-30s%s: %s\n%30s%s%s%s\n", f.what.c_str(), f.read.empty() ? "-" : f.read.c_str(), qualify::name_of(f.verdict), "",
                 f.why.c_str(), f.remedy.empty() ? "" : " ", f.remedy.c_str());
  }
  for (const std::string& remark :
       {figures.sensors_unknown, figures.practice_unknown, figures.cold_unknown, figures.timer_unknown, figures.cause_unknown}) {
    if (!remark.empty()) std::fprintf(to, "%s\n", remark.c_str());
  }
}

void run(QualifyOptions& options) {
  const Interruption interruption;
  options.wish.is_over = [&interruption] { return interruption.has_come(); };
  std::FILE* to = is_standard(options.json) ? stderr : text_stream(options.page);
  const auto measured = [&] {
    try {
      return qualify::measure(options.to, options.wish, [](const std::string& step) { std::fprintf(stderr, "%s\n", step.c_str()); });
    } catch (const InputError&) {
      if (!interruption.has_come()) throw;
      throw InputError(options.to + ": the measurement was interrupted before anything was measured");
    }
  };
  const qualify::Figures figures = measured();
  const std::vector<qualify::Judgement> judgements = qualify::judge(figures, options.limits);
  print(to, figures, judgements);
  std::fflush(to);  // known, even where no file can be written
  // One file that cannot be written does not cost the other one.
  std::exception_ptr unwritten;
  const auto write = [&](const std::filesystem::path& file, const std::string& text) {
    try {
      if (!file.empty()) write_file(file, text);
    } catch (const InputError&) {
      if (!unwritten) unwritten = std::current_exception();
    }
  };
  write(options.page, qualify::html_report(figures, judgements));
  write(options.json, json_text(qualify::json_report(figures, judgements), 2) + "\n");
  if (unwritten) std::rethrow_exception(unwritten);
  if (figures.is_cut()) throw EndedEarly(figures.end_unknown + "; the figures are those until then: " + qualify::sentence(judgements));
  if (!qualify::is_fit(judgements)) throw ComparisonFailed(options.to + ": " + qualify::sentence(judgements));
  std::fprintf(to, "%s: %s\n", options.to.c_str(), qualify::sentence(judgements).c_str());
}

}  // namespace

void add_qualify(CLI::App& app) {
  auto options = std::make_shared<QualifyOptions>();
  CLI::App* command = app.add_subcommand(
      "qualify", "Check whether a board can render forces: measures its ticks, timers and temperature; exit code 3 if it cannot");
  add_address(*command, options->to);
  add_output(*command, "-o,--out", options->page, {&forms::kPage}, "write the report as a page");
  add_output(*command, "--json", options->json, {&forms::kJson}, "write the same figures as an object");
  command->add_option("--seconds", options->wish.seconds, "how long to measure the ticks, and as long again with cyclictest, s")
      ->check(number_in(1.0, 86400.0))
      ->capture_default_str();
  command
      ->add_option("--cold-seconds", options->wish.cold_seconds,
                   "how long to measure ticks while other programs write to memory, at most --seconds, s; 0: not at all")
      ->check(number_in(0.0, 3600.0))
      ->capture_default_str();
  command->add_option("--priority", options->wish.priority, "priority of cyclictest (without this, the tick's own); 0: do not run it")
      ->check(whole_number_in(0, 99));
  command->add_flag_callback(
      "--no-trace", [options] { options->wish.trace = false; },
      "do not use the kernel's tracer; the report then names no causes of late ticks");
  qualify::Limits& limits = options->limits;
  const auto limit = [command](const char* names, double& value, const std::string& about) {
    command->add_option(names, value, "limit: " + about)->check(number_in(0, 1e9))->capture_default_str();
  };
  limit("--missed", limits.left_out, "missed ticks, percent");
  limit("--late", limits.late_ticks, "number of late ticks, also while other programs write to memory");
  limit("--wakeup-us", limits.wakeup_us, "99.9th percentile of the wake-up delay, us; 0: a tenth of the period");
  limit("--round-trip-us", limits.round_trip_us, "99.9th percentile of the device's round trip, us");
  limit("--word-ticks", limits.word_ticks, "longest delay from sensor to motor command, ticks");
  limit("--lost-samples", limits.lost_samples, "lost samples, percent; one is expected in each tick, but at most one in a millisecond");
  limit("--celsius", limits.celsius, "temperature");
  limit("--page-faults", limits.page_faults, "page faults of the tick");
  limit("--allocations", limits.allocations, "allocations of the tick");
  limit("--faults", limits.faults, "checks that find the controller in fault, one per second, and after each later part");
  limit("--inactive", limits.inactive,
        "checks that find no force, because the hand touches nothing or the controller is not active, percent");
  limit("--cold-tick-us", limits.cold_tick_us,
        "99th percentile of a tick's time while other programs write to memory, us; 0: a tenth of the period");
  command->callback([options] {
    options->wish.wakeup_us = options->limits.wakeup_us;
    require_apart(options->page, is_standard(options->json));
    run(*options);
  });
}

}  // namespace isotouch::commands
