/// What no option of our programs takes. It is wrong usage.
///
/// returns   each: why it does not take this text; empty: it may
/// real time no: before a program does anything else
#pragma once

#include <cerrno>
#include <cstdint>
#include <cstdlib>
#include <string>

namespace isotouch::files {

/// What a variable of the shell leaves that is not set.
inline std::string refusal_of_empty(const std::string& text) {
  return text.empty() ? "its value is empty; name one, or check the variable of the shell that it comes from" : "";
}

/// For an option of a whole number without a sign: a parser makes another number of one below zero, or of more than 64 bits.
///
/// low, high   what it may be at least and at most
inline std::string refusal_of_other_number(const std::string& text, std::uint64_t low = 0, std::uint64_t high = UINT64_MAX) {
  errno = 0;
  char* end = nullptr;
  const unsigned long long value = std::strtoull(text.c_str(), &end, 0);
  const bool is_other = *end != '\0' || text.find('-') != std::string::npos || errno == ERANGE || value < low || value > high;
  return is_other ? "'" + text + "' is not a whole number from " + std::to_string(low) + " to " + std::to_string(high) : "";
}

}  // namespace isotouch::files
