/// What a program answers to `--version`.
#pragma once

#include <string>

namespace isotouch::files {

/// One line: program, version, commit, the newest version of each format that it writes, compiler.
std::string version_text(const std::string& program);

}  // namespace isotouch::files
