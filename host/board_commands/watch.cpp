/// isotouch watch: the ticks of a running controller as they come, as lines.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <memory>
#include <nlohmann/json.hpp>
#include <span>
#include <string>

#include "host/board_commands/commands.h"
#include "host/board_commands/controller_options.h"
#include "host/board_commands/interruption.h"
#include "host/board_commands/number_in.h"
#include "host/board_commands/print_json.h"
#include "host/error.h"
#include "host/link/controller.h"
#include "host/to_double.h"
#include "shared/trace.h"

namespace isotouch::commands {

namespace {

struct WatchOptions {
  std::string to;
  double rate = 10;
  double seconds = 0;
  bool json = false;
};

void print_line(std::uint64_t tick, const TraceRecord& record, bool json) {
  const Eigen::Vector3d hip = to_double(record.output.hip), proxy = to_double(record.output.proxy), force = to_double(record.output.force);
  const char* state = state_name(record.output.state);
  if (json) {
    const nlohmann::ordered_json line{{"tick", tick},
                                      {"state", state},
                                      {"hip_mm", {hip.x(), hip.y(), hip.z()}},
                                      {"proxy_mm", {proxy.x(), proxy.y(), proxy.z()}},
                                      {"force_n", {force.x(), force.y(), force.z()}},
                                      {"age", record.input.age},
                                      {"buttons", record.output.buttons},
                                      {"status", record.output.status}};
    print_json(line, -1);
  } else {
    std::printf("%llu,%s,%.4f,%.4f,%.4f,%.4f,%.4f,%.4f,%.4f,%.4f,%.4f,%u,%u,%u\n", static_cast<unsigned long long>(tick), state, hip.x(),
                hip.y(), hip.z(), proxy.x(), proxy.y(), proxy.z(), force.x(), force.y(), force.z(), unsigned{record.input.age},
                unsigned{record.output.buttons}, unsigned{record.output.status});
  }
}

void run(const WatchOptions& options) {
  using trace_layout::kRecordBytes;
  link::Controller controller(options.to);
  const double ticks_a_second = 1e9 / std::max(controller.welcome().period_ns, 1U);
  const auto every = static_cast<std::uint32_t>(std::max(1.0, std::round(ticks_a_second / options.rate)));
  const auto records =
      options.seconds > 0 ? static_cast<std::uint64_t>(std::max(1.0, std::round(options.seconds * ticks_a_second / every))) : UINT64_MAX;
  if (!options.json) std::printf("tick,state,x_mm,y_mm,z_mm,proxy_x_mm,proxy_y_mm,proxy_z_mm,fx_n,fy_n,fz_n,age,buttons,status\n");
  std::uint64_t shown = 0;
  const Interruption interruption;
  const auto show = [&](std::uint64_t tick, std::span<const std::uint8_t> bytes) {
    const auto record = bytes.size() == kRecordBytes ? decode_record(bytes.first<kRecordBytes>()) : Result<TraceRecord>(Error::kBadRecord);
    if (!record) throw InputError(options.to + ": a record cannot be read; install the same release on both sides");
    print_line(tick, *record, options.json);
    if (every > 1) std::fflush(stdout);
    ++shown;
  };
  const auto [lost, ended] = controller.watch(every, records, show, [&] { return interruption.has_come(); });
  std::fprintf(stderr, "%llu ticks shown, one of every %u, %llu lost because they were read too slowly\n",
               static_cast<unsigned long long>(shown), every, static_cast<unsigned long long>(lost));
  if (!ended.empty()) throw EndedEarly(ended);
}

}  // namespace

void add_watch(CLI::App& app) {
  auto options = std::make_shared<WatchOptions>();
  CLI::App* command =
      app.add_subcommand("watch", "Print the ticks of a running controller: state, positions and force, one line for each tick");
  add_address(*command, options->to);
  command->add_option("--rate", options->rate, "lines per second, at most the tick rate")
      ->check(number_in(0.01, 10000.0))
      ->capture_default_str();
  command->add_option("--seconds", options->seconds, "how long; by default until Ctrl-C")->check(number_in(0.001, 86400.0));
  command->add_flag("--json", options->json, "print one JSON object per line instead of comma-separated values");
  command->callback([options] { run(*options); });
}

}  // namespace isotouch::commands
