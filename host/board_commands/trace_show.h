/// isotouch trace show.
#pragma once

#include <CLI/CLI.hpp>

namespace isotouch::commands {

void add_show(CLI::App& trace);

}  // namespace isotouch::commands
