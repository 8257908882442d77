/// From a command line to an exit code, for every program whose sub-commands stand here.
#pragma once

#include <CLI/CLI.hpp>

namespace isotouch::commands {

/// Parses the command line and does what it asks; what is thrown becomes one sentence on standard error.
///
/// app       with its sub-commands, of which one must be named
/// returns   0 done, 1 bad input, 2 wrong usage, 3 a comparison failed, 4 ended early and what came is kept
int run(CLI::App& app, int argc, char** argv);

}  // namespace isotouch::commands
