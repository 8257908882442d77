/// A text as one cell of a CSV table.
#pragma once

#include <string>

namespace isotouch {

/// Puts the text in quotes if it holds a comma, a quote or a line's end, and doubles its quotes; otherwise it stays as it is. It never fails.
///
/// source    RFC 4180
inline std::string csv_cell(const std::string& text) {
  if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char c : text) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
  return quoted + '"';
}

}  // namespace isotouch
