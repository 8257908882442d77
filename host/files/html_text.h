/// A text within a page.
#pragma once

#include <string>
#include <string_view>

namespace isotouch {

/// With entities for the characters that HTML takes for its own, also within quotes.
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
