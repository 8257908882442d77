/// What no option takes, whichever command it belongs to.
#pragma once

#include <CLI/CLI.hpp>

namespace isotouch::commands {

/// Lets every option and argument of all commands below `app` refuse what shared/files/option_values.h says: an empty text, and where it takes a whole number
/// without a sign, one below zero or of more than 64 bits.
void check_every_option(CLI::App& app);

}  // namespace isotouch::commands
