#include "host/board_commands/help_formatter.h"

#include <sstream>
#include <utility>

namespace isotouch::commands {

namespace {

/// What an option wants, as the parser describes it: the type of its value, and which values it takes.
struct Wanted {
  std::string type;    ///< empty: a flag
  std::string values;  ///< empty: any
};

Wanted wanted_by(const CLI::Option& option) {
  if (option.get_type_size() == 0 || option.get_expected_max() == 0) return {};
  const std::string told = option.get_type_name();
  const std::size_t colon = told.find(':');
  Wanted wanted{told.substr(0, colon), colon == std::string::npos ? "" : told.substr(colon + 1)};
  if (wanted.type == "FLOAT" || wanted.type == "INT" || wanted.type == "UINT") wanted.type = "NUMBER";
  if (wanted.type == "ENUM" || wanted.type == "BOOLEAN") wanted.type = "NAME";
  return wanted;
}

}  // namespace

std::string HelpFormatter::make_option(const CLI::Option* option, bool is_positional) const {
  const Wanted wanted = wanted_by(*option);
  std::string name = make_option_name(option, is_positional), text = option->get_description();
  if (!is_positional && !wanted.type.empty()) name += " " + wanted.type;
  if (!wanted.values.empty()) text += (text.empty() ? "" : "; ") + wanted.values;
  if (const std::string standard = option->get_default_str(); !standard.empty()) text += "; default " + standard;
  if (option->get_required() && !is_positional) text += " (required)";
  return two_columns(name, text);
}

std::string HelpFormatter::make_subcommand(const CLI::App* command) const {
  return two_columns(command->get_display_name(), command->get_description());
}

std::string HelpFormatter::two_columns(const std::string& name, const std::string& text) {
  std::string lines, line = "  " + name;
  if (line.size() + 2 > kNames) lines += std::exchange(line, "") + "\n";
  line.resize(kNames, ' ');
  bool begun = false;
  std::istringstream words(text);
  for (std::string word; words >> word; begun = true) {
    if (begun && line.size() + 1 + word.size() > kWidth) {
      lines += std::exchange(line, std::string(kNames, ' ')) + "\n";
      begun = false;
    }
    line += (begun ? " " : "") + word;
  }
  return lines + line + "\n";
}

}  // namespace isotouch::commands
