#include "firmware/settings/ascii_toml.h"

namespace isotouch::settings {

AsciiToml ascii_toml(std::string_view text) {
  enum class In { kNothing, kComment, kString, kLongString };
  if (text.substr(0, 3) == "\xEF\xBB\xBF") text.remove_prefix(3);
  AsciiToml toml{std::string(text)};
  In in = In::kNothing;
  char quote = 0;
  std::size_t line = 1;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    const bool three = text.substr(i, 3) == std::string(3, c);
    if (static_cast<unsigned char>(c) >= 0x80) {
      if (in == In::kComment) {
        toml.text[i] = '?';
      } else if (toml.stray_line == 0) {
        toml.stray_line = line;
      }
    } else if (c == '\n') {
      ++line;
      if (in != In::kLongString) in = In::kNothing;  // a string that does not end on its line is refused anyway
    } else if (in == In::kNothing) {
      if (c == '#') in = In::kComment;
      if (c == '"' || c == '\'') {
        quote = c;
        in = three ? In::kLongString : In::kString;
        i += three ? 2 : 0;
      }
    } else if (c == '\\' && quote == '"' && in != In::kComment) {
      const bool escapes_quote = text.substr(i + 1, 1) == "\"" || text.substr(i + 1, 1) == "\\";
      i += escapes_quote ? 1 : 0;
    } else if (c == quote && (in == In::kString || (in == In::kLongString && three))) {
      i += in == In::kLongString ? 2 : 0;
      in = In::kNothing;
    }
  }
  return toml;
}

}  // namespace isotouch::settings
