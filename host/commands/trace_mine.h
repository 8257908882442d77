/// isotouch trace mine: nasty recordings out of recorded ones.
#pragma once

#include <CLI/CLI.hpp>

namespace isotouch::commands {

/// Adds `mine` to the sub-commands of `trace`.
void add_mine(CLI::App& trace);

}  // namespace isotouch::commands
