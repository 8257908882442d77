/// isotouch set: one setting of how it feels, while it is felt.
#include <cstdio>
#include <memory>
#include <string>

#include "host/board_commands/commands.h"
#include "host/board_commands/controller_options.h"
#include "host/link/controller.h"

namespace isotouch::commands {

void add_set(CLI::App& app) {
  struct Options {
    std::string name, value, to;
  };
  auto options = std::make_shared<Options>();
  CLI::App* command = app.add_subcommand("set", "Change a setting while the object is being touched; the force follows with a ramp");
  command->add_option("KEY", options->name, "name of a setting in section [feel], such as friction or stiffness")->required();
  command->add_option("VALUE", options->value, "a number in the unit of the settings file")->required();
  add_address(*command, options->to);
  command->callback([options] {
    link::Controller(options->to).set(options->name, options->value);
    std::printf("%s = %s\n", options->name.c_str(), options->value.c_str());
  });
}

}  // namespace isotouch::commands
