/// TOML as far as toml++ 3.3 survives it: its table of blanks ends in undefined behaviour for many characters beyond ASCII, µ and é among them, so it never
/// sees one.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace isotouch::settings {

struct AsciiToml {
  std::string text;
  std::size_t stray_line = 0;  ///< of the first character beyond ASCII outside comments, from 1; 0 = there is none
};

/// Puts ? in the place of every byte beyond ASCII of a comment, and takes a mark of UTF-8 at the beginning away; lines stay where they are. A string may
/// hold such characters as \uXXXX.
AsciiToml ascii_toml(std::string_view text);

}  // namespace isotouch::settings
