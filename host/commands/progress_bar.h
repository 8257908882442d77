/// How far a long command is, drawn in one line of a terminal.
#pragma once

#include "host/field/progress.h"

namespace isotouch::commands {

/// For `field::Progress`. Draws on standard error when that is a terminal, else there is nothing to show; wipes its line at the end of every stage
/// and when it is destroyed, so that no message stands behind half a bar.
field::Progress::Show progress_bar();

}  // namespace isotouch::commands
