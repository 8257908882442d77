/// isotouch stop and resume: forces off, and on again.
#include <memory>
#include <string>

#include "host/board_commands/commands.h"
#include "host/board_commands/controller_options.h"
#include "host/link/controller.h"

namespace isotouch::commands {

void add_stop(CLI::App& app) {
  auto to = std::make_shared<std::string>();
  CLI::App* command = app.add_subcommand("stop", "Switch the force off from the next tick on, until 'isotouch resume'");
  add_address(*command, *to);
  command->callback([to] { link::Controller(*to).stop(); });
}

void add_resume(CLI::App& app) {
  auto to = std::make_shared<std::string>();
  CLI::App* command = app.add_subcommand("resume", "Leave a fault, if its cause is gone; the force rises from zero");
  add_address(*command, *to);
  command->callback([to] { link::Controller(*to).resume(); });
}

}  // namespace isotouch::commands
