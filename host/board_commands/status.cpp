/// isotouch status: how a running controller is.
#include <algorithm>
#include <array>
#include <cstdio>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "host/board_commands/commands.h"
#include "host/board_commands/controller_options.h"
#include "host/board_commands/print_field.h"
#include "host/error.h"
#include "host/link/controller.h"
#include "host/trace/hash_text.h"
#include "shared/fault_names.h"

namespace isotouch::commands {

namespace {

struct Options {
  std::string to;
  std::string field;  ///< only this value of the JSON object
  bool json = false;
};

constexpr std::array<const char*, 3> kAnglesFrom = {"geometry", "settings", "measured"};  ///< protocol::AnglesFrom in words

std::string angles_from(const protocol::DeviceReport& device) {
  return device.from < kAnglesFrom.size() ? kAnglesFrom[device.from] : "unknown";
}

nlohmann::ordered_json to_json(const protocol::StatusReport& status, const protocol::DeviceReport& device,
                               const protocol::Welcome& welcome) {
  nlohmann::ordered_json json{{"program", welcome.program.view()},
                              {"state", state_name(status.state)},
                              {"ticks", status.ticks},
                              {"late", status.late},
                              {"faults", fault_names(status.faults)},
                              {"field_hash", nullptr}};
  if (status.field_hash != 0) json["field_hash"] = trace::hash_text(status.field_hash);
  for (std::size_t i = 0; i < protocol::kMeasures; ++i) {
    const auto in = [&](std::uint32_t ns) { return in_unit(kMeasureNames[i], ns, welcome.period_ns); };
    const protocol::Quantiles& q = status.measures[i];
    json[kMeasureNames[i].key] = {{"p50", in(q.p50)}, {"p999", in(q.p999)}, {"max", in(q.max)}};
  }
  json["allocations"] = status.allocations;
  json["page_faults"] = status.page_faults;
  json["device"] = {{"serial", device.serial.view()},
                    {"angles_from", angles_from(device)},
                    {"angle_at_zero_deg", {degrees_of(device.at_zero[0]), degrees_of(device.at_zero[1]), degrees_of(device.at_zero[2])}},
                    {"other_angles_wait", device.waits != 0}};
  return json;
}

void print_text(const protocol::StatusReport& status, const protocol::DeviceReport& device, const protocol::Welcome& welcome) {
  std::printf("%-17s%s\n", "state", state_text(status).c_str());
  std::printf("%-17s%s\n", "field", status.field_hash == 0 ? "none" : trace::hash_text(status.field_hash).c_str());
  std::printf("%-17s%llu, of which late %llu\n", "ticks", static_cast<unsigned long long>(status.ticks),
              static_cast<unsigned long long>(status.late));
  for (std::size_t i = 0; i < protocol::kMeasures; ++i) {
    const auto in = [&](std::uint32_t ns) { return in_unit(kMeasureNames[i], ns, welcome.period_ns); };
    const protocol::Quantiles& q = status.measures[i];
    std::printf("%-17smedian %.1f, 99.9 %% %.1f, largest %.1f %s\n", kMeasureNames[i].text, in(q.p50), in(q.p999), in(q.max),
                kMeasureNames[i].in_ticks ? "ticks" : "us");
  }
  std::printf("%-17s%llu, page faults %llu\n", "allocations", static_cast<unsigned long long>(status.allocations),
              static_cast<unsigned long long>(status.page_faults));
  std::printf("%-17s%s, arms at count 0 at %.3f, %.3f, %.3f degrees (%s)%s\n", "device",
              device.serial.size == 0 ? "none" : std::string(device.serial.view()).c_str(), degrees_of(device.at_zero[0]),
              degrees_of(device.at_zero[1]), degrees_of(device.at_zero[2]), angles_from(device).c_str(),
              device.waits != 0 ? "; other angles are stored and take effect at the next start" : "");
}

void run(const Options& options) {
  link::Controller controller(options.to);
  const protocol::StatusReport status = controller.status();
  const protocol::DeviceReport device = controller.welcome().minor >= 1 ? controller.device() : protocol::DeviceReport{};
  if (!options.field.empty()) return print_field(to_json(status, device, controller.welcome()), options.field);
  if (!options.json) return print_text(status, device, controller.welcome());
  std::printf("%s\n", to_json(status, device, controller.welcome()).dump(2).c_str());
}

}  // namespace

void add_status(CLI::App& app) {
  auto options = std::make_shared<Options>();
  CLI::App* command = app.add_subcommand("status", "Print the state of a running controller, its faults, field and times");
  add_address(*command, options->to);
  command->add_flag("--json", options->json, "print one JSON object");
  command->add_option("--field", options->field, "print only the value with this key of the JSON object, such as tick_us.p999");
  command->callback([options] { run(*options); });
}

}  // namespace isotouch::commands
