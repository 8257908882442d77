/// isotouch status: how a running controller is.
#include <cstdio>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>

#include "host/board_commands/commands.h"
#include "host/board_commands/controller_options.h"
#include "host/board_commands/print_json.h"
#include "host/board_commands/print_key.h"
#include "host/link/controller.h"
#include "host/link/status.h"
#include "host/trace/hash_text.h"
#include "shared/fault_names.h"

namespace isotouch::commands {

namespace {

struct StatusOptions {
  std::string to;
  std::string key;  ///< only this value of the JSON object
  bool json = false;
};

void print_text(const link::ControllerStatus& seen) {
  const protocol::StatusReport& status = seen.status;
  std::printf("%-17s%s\n", "state", link::sentence(seen).c_str());
  if (seen.verdict() != GuardVerdict::kNone)
    std::printf("%-17sstopped a motor command %s\n", "guard", std::string(name_of(seen.verdict())).c_str());
  const std::string name = status.field_name.size == 0 ? "" : std::string(status.field_name.view()) + ", ";
  std::printf("%-17s%s\n", "field", status.field_hash == 0 ? "none" : (name + trace::hash_text(status.field_hash)).c_str());
  std::printf("%-17s%llu, of which late %llu\n", "ticks", static_cast<unsigned long long>(status.ticks),
              static_cast<unsigned long long>(status.late));
  for (std::size_t i = 0; i < protocol::kMeasures; ++i) {
    const auto in = [&](std::uint32_t ns) { return in_unit(kMeasureNames[i], ns, seen.welcome.period_ns); };
    const protocol::Quantiles& q = status.measures[i];
    std::printf("%-17smedian %.1f, 99.9 %% %.1f, largest %.1f %s\n", kMeasureNames[i].text, in(q.p50), in(q.p999), in(q.max),
                kMeasureNames[i].in_ticks ? "ticks" : "us");
  }
  std::printf("%-17s%llu, page faults %llu\n", "allocations", static_cast<unsigned long long>(status.allocations),
              static_cast<unsigned long long>(status.page_faults));
  const protocol::DeviceReport& device = seen.device;
  std::printf("%-17s%s, arms at count 0 at %.3f, %.3f, %.3f degrees (%s)%s\n", "device",
              device.serial.size == 0 ? "none" : std::string(device.serial.view()).c_str(), degrees_of(device.at_zero[0]),
              degrees_of(device.at_zero[1]), degrees_of(device.at_zero[2]), link::angles_from(device).c_str(),
              device.waits != 0 ? "; this device has other angles" : "");
  std::printf("%-17s%s\n", "your role", std::string(seen.role()).c_str());
  std::printf("%-17schecksum %s; %s\n", "settings", trace::hash_text(seen.settings.checksum).c_str(),
              seen.settings.different.empty() ? "all have their defaults" : "those that differ from their defaults:");
  for (const auto& [setting, value] : seen.settings.different) std::printf("%-17s%s = %s\n", "", setting.c_str(), value.c_str());
}

void run(const StatusOptions& options) {
  link::Controller controller(options.to);
  const link::ControllerStatus seen = link::whole_status(controller);
  if (!options.key.empty()) return print_key(link::to_json(seen), options.key);
  if (!options.json) return print_text(seen);
  print_json(link::to_json(seen));
}

}  // namespace

void add_status(CLI::App& app) {
  auto options = std::make_shared<StatusOptions>();
  CLI::App* command = app.add_subcommand("status", "Print the state of a running controller, its faults, field and times");
  add_address(*command, options->to);
  command->add_flag("--json", options->json, "print one JSON object");
  command->add_option("--key", options->key, "print only the value with this key of the JSON object, such as tick_us.p999");
  command->callback([options] { run(*options); });
}

}  // namespace isotouch::commands
