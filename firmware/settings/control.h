/// The settings of the control socket: names of users and groups become numbers.
#pragma once

#include <string>

#include "firmware/control/control_server.h"
#include "firmware/settings/settings.h"
#include "shared/files/refusal.h"

namespace isotouch::settings {

/// Fills in path, mode, group and who may come in; asks the system for users and groups.
///
/// returns   a name or number is none
Refusal apply_control(const Settings& settings, control::ControlSettings& control);

}  // namespace isotouch::settings
