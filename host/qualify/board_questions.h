/// What a board is asked in its shell's language, and how its answers are read. Nothing is written there but a folder of the kernel's tracer, which is
/// taken away again.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
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
/// Temperature sensors that gave a number, and those that are there and gave none.
struct Sensors {
  std::size_t read = 0, silent = 0;
};
/// Fills `celsius` and `megahertz` with what there is.
Sensors read_sensors(const std::string& text, Moment& moment);

/// cyclictest: one thread of this priority that wakes up so often for so long; where the tick is bound to one processor, on that one, and with the power
/// management that the tick has.
std::string timer_command(int priority, std::uint32_t period_us, double seconds);
/// Its histogram of microseconds, and the longest delays that it counted beyond.
///
/// why       when nothing is returned: one sentence why
std::optional<link::Histogram> read_timer(int status, const std::string& text, std::string& why);

/// Programs that write 64 MiB of memory over and over for so long, one for each of up to eight processors, so that what the tick needs is in no cache. They
/// run only when nothing else wants to, and outlive a connection that is cut by no more than this time.
std::string eviction_command(double seconds);

/// The kernel's tracer: a buffer of its own that always holds the last second or so, with every switch of threads and every interrupt.
/// It is there whole, or not at all.
std::string begin_tracing_command();
/// Takes it away; nothing when it is not there.
std::string end_tracing_command();
/// What it holds of the times from when each of these ticks should have begun to when it began; read once, because it is long.
std::string trace_command(std::span<const protocol::WorstTick> ticks);
/// Which threads and interrupts had each tick's processor, in that time.
///
/// ticks     so many were asked for
/// returns   one for each; empty: the tracer does not know
std::vector<std::string> read_causes(const std::string& text, std::size_t ticks);

}  // namespace isotouch::qualify
