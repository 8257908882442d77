/// How far a long command is, drawn in one line of a terminal.
#pragma once

#include "host/field/progress.h"

namespace isotouch::commands {

/// For `field::Progress`. Draws on standard error when that is a terminal, else does nothing; wipes its line when it is destroyed or when a stage ends.
field::Progress::Show progress_bar();

}  // namespace isotouch::commands
