/// The settings of the control socket: names of users and groups become numbers.
#pragma once

#include <string>

#include "firmware/control/control_server.h"
#include "firmware/settings/settings.h"

namespace isotouch::settings {

/// Fills in path, mode, group and who may come in; asks the system for users and groups.
///
/// returns   one sentence when a name or number is none; empty when all is well
std::string apply_control(const Settings& settings, control::ControlSettings& control);

}  // namespace isotouch::settings
