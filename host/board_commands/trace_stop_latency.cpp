#include "host/board_commands/trace_stop_latency.h"
#include "host/board_commands/number_in.h"
#include "host/board_commands/print_json.h"

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "host/board_commands/commands.h"
#include "host/board_commands/controller_options.h"
#include "host/error.h"
#include "host/trace/fault_response.h"
#include "host/trace/trace_file.h"

namespace isotouch::commands {

namespace {

struct TraceStopLatencyOptions {
  std::filesystem::path trace;
  std::uint64_t most = 3;
  bool json = false;
};

using Responses = std::vector<trace::FaultResponse>;

const char* state_of(const trace::FaultResponse& response) { return state_name(static_cast<std::uint16_t>(response.state)); }

/// Of the slowest response; null where there is none, or one that never came.
nlohmann::ordered_json slowest(const Responses& responses) {
  nlohmann::ordered_json most = nullptr;
  for (const trace::FaultResponse& response : responses) {
    if (!response.ticks) return nullptr;
    if (most.is_null() || most < *response.ticks) most = *response.ticks;
  }
  return most;
}

void print_rows(const Responses& responses) {
  nlohmann::ordered_json rows = nlohmann::ordered_json::array();
  for (const trace::FaultResponse& response : responses) {
    nlohmann::ordered_json ticks = nullptr;
    if (response.ticks) ticks = *response.ticks;
    rows.push_back({{"tick", response.tick}, {"condition", response.condition}, {"ticks_to_zero", ticks}, {"state", state_of(response)}});
  }
  const nlohmann::ordered_json json{{"ticks_to_zero", slowest(responses)}, {"responses", rows}};
  print_json(json);
}

void print_text(const Responses& responses) {
  if (responses.empty()) std::printf("nothing was tested: while there were motor commands, no input forbade them\n");
  if (!responses.empty()) std::printf("%10s  %-20s %8s  %s\n", "tick", "condition", "to zero", "state");
  for (const trace::FaultResponse& response : responses) {
    std::printf("%10llu  %-20s %8s  %s\n", static_cast<unsigned long long>(response.tick), response.condition.c_str(),
                response.ticks ? std::to_string(*response.ticks).c_str() : "never", state_of(response));
  }
}

void run(const TraceStopLatencyOptions& options) {
  const Responses responses = trace::fault_responses(trace::read_trace(options.trace, InputKind::kPacket));
  options.json ? print_rows(responses) : print_text(responses);
  for (const trace::FaultResponse& response : responses) {
    if (response.ticks && *response.ticks <= options.most) continue;
    throw ComparisonFailed(options.trace.string() + ": tick " + std::to_string(response.tick) + " shows '" + response.condition +
                           "', and motor commands are not zero within " + std::to_string(options.most) + " ticks");
  }
}

}  // namespace

void add_stop_latency(CLI::App& trace) {
  auto options = std::make_shared<TraceStopLatencyOptions>();
  CLI::App* command = trace.add_subcommand(
      "stop-latency",
      "Count the ticks from each input that forbids forces to motor commands of zero; exit code 3 when one took longer than allowed");
  command->add_option("TRACE", options->trace, "a controller's recording (.trace)")->required();
  command->add_option("--most", options->most, "ticks allowed")->check(whole_number_in(0, 1'000'000))->capture_default_str();
  command->add_flag("--json", options->json, "print one JSON object");
  command->callback([options] { run(*options); });
}

}  // namespace isotouch::commands
