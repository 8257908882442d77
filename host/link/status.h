/// All that a controller says of itself, and the JSON object of it.
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

/// fails     as the functions of Controller
ControllerStatus whole_status(Controller& controller);

/// Where the angles in use come from, in a word.
std::string angles_from(const protocol::DeviceReport& device);

/// As `isotouch status --json` prints it.
nlohmann::ordered_json to_json(const ControllerStatus& seen);

}  // namespace isotouch::link
