/// isotouchctl: what a controller's own board needs of isotouch. It speaks with the controller and replays what it recorded;
/// what makes, compares and draws fields, and the libraries for that, stay on the desk.
#include <CLI/CLI.hpp>

#include "host/board_commands/commands.h"
#include "host/board_commands/run.h"
#include "host/board_commands/trace_show.h"
#include "host/board_commands/trace_stop_latency.h"

namespace {

void add_commands(CLI::App& app) {
  using namespace isotouch;
  commands::add_on_board(app);
  CLI::App* trace = app.add_subcommand("trace", "Show and judge a controller's recording");
  trace->require_subcommand(1);
  commands::add_show(*trace);
  commands::add_stop_latency(*trace);
}

}  // namespace

int main(int argc, char** argv) {
  return isotouch::commands::run("isotouchctl",
                                 "Talks to a haptic controller, and replays what it recorded: the commands of isotouch that a board needs.",
                                 add_commands, argc, argv);
}
