/// What a program answers to `--version`.
#pragma once

#include <string>

namespace isotouch::files {

/// Program, version and commit; fits a text of the protocol.
std::string short_version_text(const std::string& program);

/// One line: program, version, commit, the newest version of each format that it writes, compiler.
std::string version_text(const std::string& program);

}  // namespace isotouch::files
