#include "host/board_commands/every_option.h"

#include "shared/files/option_values.h"

namespace isotouch::commands {

void check_every_option(CLI::App& app) {
  for (CLI::Option* option : app.get_options({})) {
    if (option->get_type_size() == 0 || option->get_expected_max() == 0) continue;  // a flag
    option->transform(CLI::Validator(files::refusal_of_empty, ""));                 // before its other checks
    if (option->get_type_name() == "UINT")
      option->transform(CLI::Validator([](std::string& text) { return files::refusal_of_other_number(text); }, ""));
  }
  for (CLI::App* command : app.get_subcommands({})) check_every_option(*command);
}

}  // namespace isotouch::commands
