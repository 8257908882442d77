/// A text as part of an HTML page.
#pragma once

#include <string>
#include <string_view>

namespace isotouch {

/// Replaces <, >, & and " by entities, so that the text may stand between tags or as an attribute's value in double quotes. It never fails.
inline std::string html_text(std::string_view text) {
  std::string out;
  for (const char c : text) {
    if (c == '<')
      out += "&lt;";
    else if (c == '>')
      out += "&gt;";
    else if (c == '&')
      out += "&amp;";
    else if (c == '"')
      out += "&quot;";
    else
      out += c;
  }
  return out;
}

}  // namespace isotouch
