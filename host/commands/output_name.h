/// The ending of an output file's name says what is written; another ending than the command writes is refused before the work.
#pragma once

#include <filesystem>
#include <string>

namespace isotouch::commands {

/// out       as typed after -o
/// written   the ending that the command writes, such as ".itf"
/// what      that is, in words: "a field"
/// instead   what to do for another form, a clause; may be empty
/// fails     InputError when the name ends as a file of another known form does. A name that says nothing is accepted
void require_form(const std::filesystem::path& out, const std::string& written, const std::string& what, const std::string& instead = {});

}  // namespace isotouch::commands
