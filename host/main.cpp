/// isotouch: from oriented points to a field that can be touched. One sub-command per file in commands/.
#include <CLI/CLI.hpp>
#include <cstring>

#ifdef __GLIBC__
#include <malloc.h>
#endif

#include "host/board_commands/run.h"
#include "host/commands/commands.h"

namespace {

/// Freed memory is kept for the next step, which wants as much: handed back, every page of it would have to be cleared and mapped again.
void keep_freed_memory() {
#ifdef __GLIBC__
  constexpr int kMegabyte = 1 << 20;
  mallopt(M_MMAP_THRESHOLD, 32 * kMegabyte);
  mallopt(M_TRIM_THRESHOLD, 256 * kMegabyte);
#endif
}

using namespace isotouch;
using commands::Command, commands::kCommands;

/// Of what was called for, or of all where that is no name: to make every command takes a third of a short call's time.
void (*commands_for(int argc, char** argv))(CLI::App& app) {
  for (const Command& command : kCommands) {
    if (argc > 1 && command.name != nullptr && std::strcmp(command.name, argv[1]) == 0) return command.add;
  }
  return commands::add_all;
}

}  // namespace

int main(int argc, char** argv) {
  keep_freed_memory();
  return commands::run("isotouch", "Turns oriented points into a distance field that a haptic controller can touch.",
                       commands_for(argc, argv), argc, argv);
}
