/// What no option takes, whichever command it belongs to.
#pragma once

#include <CLI/CLI.hpp>

namespace isotouch::commands {

/// Lets every option and argument of all commands below `app` refuse an empty text, which is what a variable of the shell leaves that is not set; and
/// every option for a whole number without a sign one that has a sign or more than 64 bits, of which the parser would make another number. It is wrong usage.
void check_every_option(CLI::App& app);

}  // namespace isotouch::commands
