/// Everything that a controller reports of itself, and the JSON object of it.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>

#include "host/link/controller.h"
#include "shared/tick_io.h"

namespace isotouch::link {

struct ControllerStatus {
  protocol::Welcome welcome;
  protocol::StatusReport status;
  protocol::DeviceReport device;
  Controller::Settings settings;

  std::string_view role() const { return protocol::name_of(static_cast<protocol::Role>(welcome.role)); }
  GuardVerdict verdict() const { return guard_verdict(status.lines); }
};

/// Asks for all four parts, one after the other.
///
/// fails     InputError naming the address: the controller does not answer, refuses, or answers in another form
ControllerStatus whole_status(Controller& controller);

/// Where the angles in use come from: "geometry", "settings", "measured", or "unknown".
std::string angles_from(const protocol::DeviceReport& device);

/// What is true for the hand, and the next step: see `files::state_text`.
std::string sentence(const protocol::StatusReport& status, const protocol::DeviceReport& device);
inline std::string sentence(const ControllerStatus& seen) { return sentence(seen.status, seen.device); }

/// The object that `isotouch status --json` prints. Times are in the unit that ends their key, such as `tick_us`.
nlohmann::ordered_json to_json(const ControllerStatus& seen);

}  // namespace isotouch::link
