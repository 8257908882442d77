/// isotouch trace mutate.
#pragma once

#include <CLI/CLI.hpp>

namespace isotouch::commands {

void add_mutate(CLI::App& trace);

}  // namespace isotouch::commands
