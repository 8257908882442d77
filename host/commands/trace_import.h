/// isotouch trace import.
#pragma once

#include <CLI/CLI.hpp>

namespace isotouch::commands {

void add_import(CLI::App& trace);

}  // namespace isotouch::commands
