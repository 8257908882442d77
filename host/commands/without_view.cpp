/// isotouch view where the page was left out: a tool for another processor than that of the machine that built it.
#include <CLI/CLI.hpp>

#include "host/commands/commands.h"
#include "host/error.h"

namespace isotouch::commands {

void add_view(CLI::App& app) {
  CLI::App* command = app.add_subcommand("view", "Show a field, recordings and a running controller on a page (left out of this program)");
  command->allow_extras();
  command->callback([] {
    throw InputError("this program was built without the page; use isotouch view on a desk, with --to and the address of this machine");
  });
}

}  // namespace isotouch::commands
