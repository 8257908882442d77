/// A text as one cell of a table with commas.
#pragma once

#include <string>

namespace isotouch {

/// In quotes where a comma, a quote or a line's end would be taken for the table's own (RFC 4180).
inline std::string csv_cell(const std::string& text) {
  if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char c : text) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
  return quoted + '"';
}

}  // namespace isotouch
