/// What no option of our programs takes. It is wrong usage.
///
/// returns   each: why it does not take this text; empty: it may
/// real time no: before a program does anything else
#pragma once

#include <cerrno>
#include <cstdlib>
#include <string>

namespace isotouch::files {

/// What a variable of the shell leaves that is not set.
inline std::string refusal_of_empty(const std::string& text) {
  return text.empty() ? "its value is empty; name one, or check the variable of the shell that it comes from" : "";
}

/// For an option of a whole number without a sign: a parser makes another number of one below zero, or of more than 64 bits.
inline std::string refusal_of_other_number(const std::string& text) {
  errno = 0;
  (void)std::strtoull(text.c_str(), nullptr, 0);
  const bool is_other = text.find('-') != std::string::npos || errno == ERANGE;
  return is_other ? "'" + text + "' is not a whole number from 0 to 18446744073709551615" : "";
}

}  // namespace isotouch::files
