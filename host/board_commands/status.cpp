/// isotouch status: how a running controller is.
#include <algorithm>
#include <array>
#include <cstdio>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
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

/// All that a controller says of itself.
struct Seen {
  protocol::Welcome welcome;
  protocol::StatusReport status;
  protocol::DeviceReport device;
  link::Controller::Settings settings;

  std::string_view role() const { return protocol::name_of(static_cast<protocol::Role>(welcome.role)); }
  GuardVerdict verdict() const { return guard_verdict(status.lines); }
};

nlohmann::ordered_json to_json(const Seen& seen) {
  const protocol::StatusReport& status = seen.status;
  nlohmann::ordered_json json{{"program", seen.welcome.program.view()},
                              {"role", seen.role()},
                              {"state", state_name(status.state)},
                              {"sentence", state_text(status)},
                              {"ticks", status.ticks},
                              {"late", status.late},
                              {"faults", fault_names(status.faults)},
                              {"guard", name_of(seen.verdict())},
                              {"field_hash", nullptr},
                              {"field_name", status.field_name.view()}};
  if (status.field_hash != 0) json["field_hash"] = trace::hash_text(status.field_hash);
  for (std::size_t i = 0; i < protocol::kMeasures; ++i) {
    const auto in = [&](std::uint32_t ns) { return in_unit(kMeasureNames[i], ns, seen.welcome.period_ns); };
    const protocol::Quantiles& q = status.measures[i];
    json[kMeasureNames[i].key] = {{"p50", in(q.p50)}, {"p999", in(q.p999)}, {"max", in(q.max)}};
  }
  json["allocations"] = status.allocations;
  json["page_faults"] = status.page_faults;
  const protocol::DeviceReport& device = seen.device;
  json["device"] = {{"serial", device.serial.view()},
                    {"angles_from", angles_from(device)},
                    {"angle_at_zero_deg", {degrees_of(device.at_zero[0]), degrees_of(device.at_zero[1]), degrees_of(device.at_zero[2])}},
                    {"other_angles_wait", device.waits != 0}};
  json["settings_checksum"] = trace::hash_text(seen.settings.checksum);
  json["settings_different"] = nlohmann::ordered_json::object();
  for (const auto& [name, value] : seen.settings.different) json["settings_different"][name] = value;
  return json;
}

void print_text(const Seen& seen) {
  const protocol::StatusReport& status = seen.status;
  std::printf("%-17s%s\n", "state", state_text(status).c_str());
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
              degrees_of(device.at_zero[1]), degrees_of(device.at_zero[2]), angles_from(device).c_str(),
              device.waits != 0 ? "; other angles are stored and take effect at the next start" : "");
  std::printf("%-17s%s\n", "your role", std::string(seen.role()).c_str());
  std::printf("%-17schecksum %s; %s\n", "settings", trace::hash_text(seen.settings.checksum).c_str(),
              seen.settings.different.empty() ? "all have their defaults" : "those that differ from their defaults:");
  for (const auto& [setting, value] : seen.settings.different) std::printf("%-17s%s = %s\n", "", setting.c_str(), value.c_str());
}

void run(const Options& options) {
  link::Controller controller(options.to);
  const Seen seen{controller.welcome(), controller.status(), controller.device(), controller.settings()};
  if (!options.field.empty()) return print_field(to_json(seen), options.field);
  if (!options.json) return print_text(seen);
  std::printf("%s\n", to_json(seen).dump(2).c_str());
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
