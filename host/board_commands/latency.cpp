/// isotouch latency: the histograms that a running controller keeps.
#include <bit>
#include <cstdint>
#include <cstdio>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>

#include "host/board_commands/commands.h"
#include "host/board_commands/controller_options.h"
#include "host/board_commands/print_json.h"
#include "host/link/controller.h"

namespace isotouch::commands {

namespace {

struct LatencyOptions {
  std::string to;
  bool json = false;
};

/// One line for every doubling of the time, with a bar on a scale that shows a single late tick among millions.
void print_text(const MeasureName& name, const link::Histogram& histogram, std::uint32_t period_ns) {
  std::printf("%s, %llu values, in %s\n", name.text, static_cast<unsigned long long>(histogram.count), name.in_ticks ? "ticks" : "us");
  for (auto bin = histogram.bins.begin(); bin != histogram.bins.end();) {
    const auto width = std::bit_width(bin->upper);  // signed or not, by the library
    std::uint64_t count = 0;
    double upper = 0.0;
    for (; bin != histogram.bins.end() && std::bit_width(bin->upper) == width; ++bin) {
      count += bin->count;
      upper = in_unit(name, bin->upper, period_ns);
    }
    std::printf("  up to %10.2f %12llu %s\n", upper, static_cast<unsigned long long>(count),
                std::string(static_cast<std::size_t>(std::bit_width(count)), '#').c_str());
  }
}

void run(const LatencyOptions& options) {
  link::Controller controller(options.to);
  const std::uint32_t period_ns = controller.welcome().period_ns;
  nlohmann::ordered_json json;
  for (std::size_t i = 0; i < protocol::kMeasures; ++i) {
    const MeasureName& name = kMeasureNames[i];
    const link::Histogram histogram = controller.histogram(static_cast<protocol::Measure>(i));
    if (!options.json) {
      print_text(name, histogram, period_ns);
      continue;
    }
    nlohmann::ordered_json bins = nlohmann::ordered_json::array();
    for (const protocol::Bin& bin : histogram.bins) bins.push_back({{"up_to", in_unit(name, bin.upper, period_ns)}, {"count", bin.count}});
    json[name.key] = {{"count", histogram.count}, {"bins", bins}};
  }
  if (options.json) print_json(json);
}

}  // namespace

void add_latency(CLI::App& app) {
  auto options = std::make_shared<LatencyOptions>();
  CLI::App* command = app.add_subcommand("latency", "Print histograms of the tick times of a running controller since its start");
  add_address(*command, options->to);
  command->add_flag("--json", options->json, "print one JSON object");
  command->callback([options] { run(*options); });
}

}  // namespace isotouch::commands
