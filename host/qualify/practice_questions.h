/// What a board is asked of its kernel and settings, in its shell's language, and how its answer is read. Nothing is changed there.
#pragma once

#include <string>

#include "host/qualify/practice.h"

namespace isotouch::qualify {

/// Reads what `judge_practice` looks at. ISOTOUCH_BOARD_ROOT names another folder than /.
std::string practice_command();

/// "path:line" lines → files; lines of one path are put together. Whatever else is printed is left out.
BoardFiles read_practice(const std::string& text);

}  // namespace isotouch::qualify
