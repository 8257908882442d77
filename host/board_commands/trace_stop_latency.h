/// isotouch trace stop-latency: how soon forces ended in a recording.
#pragma once

#include <CLI/CLI.hpp>

namespace isotouch::commands {

/// Adds `zero` to the sub-commands of `trace`.
void add_stop_latency(CLI::App& trace);

}  // namespace isotouch::commands
