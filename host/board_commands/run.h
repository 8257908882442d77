/// From a command line to an exit code, for every program whose sub-commands stand here.
#pragma once

#include <CLI/CLI.hpp>

namespace isotouch::commands {

/// Parses the command line and does what it asks; what is thrown becomes one sentence on standard error, after the program's name.
///
/// about     what the program is for, in its help
/// add       adds the sub-commands, of which one must be named
/// returns   0 done, 1 bad input or no room for what is printed, 2 wrong usage, 3 a comparison failed, 4 ended early and what came is kept
int run(const char* program, const char* about, void (*add)(CLI::App& app), int argc, char** argv);

}  // namespace isotouch::commands
