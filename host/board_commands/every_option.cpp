#include "host/board_commands/every_option.h"

#include <cerrno>
#include <cstdlib>
#include <string>

namespace isotouch::commands {

namespace {

std::string refusal_of_empty(const std::string& text) {
  return text.empty() ? "its value is empty; name one, or check the variable of the shell that it comes from" : "";
}

std::string refusal_of_other_number(const std::string& text) {
  errno = 0;
  (void)std::strtoull(text.c_str(), nullptr, 0);
  const bool is_other = text.find('-') != std::string::npos || errno == ERANGE;
  return is_other ? "'" + text + "' is not a whole number from 0 to 18446744073709551615" : "";
}

}  // namespace

void check_every_option(CLI::App& app) {
  for (CLI::Option* option : app.get_options({})) {
    if (option->get_type_size() == 0 || option->get_expected_max() == 0) continue;  // a flag
    option->transform(CLI::Validator(refusal_of_empty, ""));                        // before its other checks
    if (option->get_type_name().starts_with("UINT")) option->transform(CLI::Validator(refusal_of_other_number, ""));
  }
  for (CLI::App* command : app.get_subcommands({})) check_every_option(*command);
}

}  // namespace isotouch::commands
