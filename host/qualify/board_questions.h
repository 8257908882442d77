/// What a board is asked in its shell's language, and how its answers are read. Nothing is written there but a folder of the kernel's tracer, which is
/// taken away again.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "host/link/controller.h"
#include "host/qualify/figures.h"

namespace isotouch::qualify {

/// Who it is: model, kernel, processors, what the kernel was told at boot.
std::string describe_command();
/// "name=value" lines → pairs; other lines are none of ours.
std::vector<std::pair<std::string, std::string>> read_description(const std::string& text);

/// Temperatures and clock rates, now.
std::string sensors_command();
/// Fills `celsius` and `megahertz` with what there is.
void read_sensors(const std::string& text, Moment& moment);

/// cyclictest: one thread of this priority that wakes up so often for so long.
std::string timer_command(int priority, std::uint32_t period_us, double seconds);
/// Its histogram of microseconds, and the longest delays that it counted beyond.
///
/// why       when nothing is returned: one sentence why
std::optional<link::Histogram> read_timer(int status, const std::string& text, std::string& why);

/// The kernel's tracer: a buffer of its own that always holds the last second or so, with every switch of threads and every interrupt.
/// It is there whole, or not at all.
std::string begin_tracing_command();
/// Takes it away; nothing when it is not there.
std::string end_tracing_command();
/// What it holds of the time from when a tick should have begun to when it began.
std::string trace_command(const wire::WorstTick& tick);
/// Which threads and interrupts had the tick's processor, in that time.
///
/// returns   empty: the tracer does not know
std::string read_cause(const std::string& text);

}  // namespace isotouch::qualify
