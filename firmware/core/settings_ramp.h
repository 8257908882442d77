/// Settings that change while they are felt: each moves to its new value along a straight line, so that no force jumps.
///
/// tick      yes, every function: constant cost, no division
#pragma once

#include <cstdint>

#include "firmware/core/coupling.h"
#include "shared/tick_settings.h"

namespace isotouch::core {

struct SettingsRamp {
  LiveRaw now{};  ///< what holds
  LiveRaw target{};
  LiveRaw step{};          ///< a tick
  std::uint32_t left = 0;  ///< ticks until the target holds
};

/// Starts with all settings at their values.
void begin_settings(const TickSettings& settings, SettingsRamp& ramp);

/// Ends the ramp: the targets hold from now on.
void finish_settings(SettingsRamp& ramp);

/// Accepts a change, if there is one, and moves on by one tick.
///
/// change     a valid one, or none
/// at_once    nothing is felt: the target holds at once
/// coupling   gives the ramp's length, and the stiffness that is felt where the settings name none
/// returns    whether what holds has changed
bool advance_settings(const SettingChange& change, bool at_once, const Coupling& coupling, SettingsRamp& ramp);

}  // namespace isotouch::core
