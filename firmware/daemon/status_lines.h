/// What the daemon says of itself, for people: one line when something changes, figures at the end.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "firmware/falcon/falcon_port.h"
#include "firmware/loop/memory_check.h"
#include "firmware/loop/tick_stats.h"
#include "firmware/settings/settings.h"
#include "shared/files/state_text.h"
#include "shared/tick_io.h"

namespace isotouch::daemon {

/// How the device is doing; the same text as before when nothing changed.
std::string device_line(const falcon::PortReport& report);

/// What the supervisor allows and what a person can do.
///
/// others    as `files::state_text`
std::string supervisor_line(const files::Condition& condition, protocol::OtherAngles others = protocol::OtherAngles::kNone);

/// By what the controller was set up; recordings carry the same number.
std::string settings_line(std::uint64_t checksum);

/// The field that a run begins with.
std::string field_line(std::string_view name, std::uint64_t hash);

/// What the guard has stopped.
std::string guard_line(GuardVerdict verdict);

/// What was damaged in memory, and what to do; empty when nothing.
std::string memory_line(loop::Damage damage);

/// What the system refused; empty when nothing.
///
/// refused   loop::Refusals
std::string refusal_line(unsigned refused);

/// Why processors may fall asleep while there is force, and what to do.
///
/// file      [loop] latency_file
/// error     as loop::LatencyRequest::hold returns it, not 0
std::string latency_line(const std::string& file, int error);

/// One sentence for each protection that the safety lines do not give.
std::vector<std::string> missing_lines(const settings::Settings& settings);

/// What is not remembered where the settings name no state folder.
std::string no_state_line();

/// By which signal it ends.
std::string ending_line(int signal);

/// Several lines: how the ticks began and how long things took.
std::string figures(const loop::TickStats& stats);

}  // namespace isotouch::daemon
