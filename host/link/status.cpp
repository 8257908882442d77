#include "host/link/status.h"

#include <array>
#include <nlohmann/json.hpp>

#include "host/link/words.h"
#include "host/trace/hash_text.h"
#include "shared/files/state_text.h"

namespace isotouch::link {

namespace {

constexpr std::array<const char*, 3> kAnglesFrom = {"geometry", "settings", "measured"};  ///< protocol::AnglesFrom in words

}  // namespace

ControllerStatus whole_status(Controller& controller) {
  return {controller.welcome(), controller.status(), controller.device(), controller.settings()};
}

std::string sentence(const protocol::StatusReport& status, const protocol::DeviceReport& device) {
  return files::state_text({status.state, status.faults, status.status, status.generation != 0},
                           static_cast<protocol::OtherAngles>(device.waits), tool_name());
}

std::string angles_from(const protocol::DeviceReport& device) {
  return device.from < kAnglesFrom.size() ? kAnglesFrom[device.from] : "unknown";
}

nlohmann::ordered_json to_json(const ControllerStatus& seen) {
  const protocol::StatusReport& status = seen.status;
  nlohmann::ordered_json json{{"program", seen.welcome.program.view()},
                              {"role", seen.role()},
                              {"state", files::state_name(status.state)},
                              {"sentence", sentence(seen)},
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

}  // namespace isotouch::link
