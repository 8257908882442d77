/// isotouch: from oriented points to a field that can be touched. One sub-command per file in commands/.
#include <CLI/CLI.hpp>

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

void add_commands(CLI::App& app) {
  using namespace isotouch;
  commands::add_build(app);
  commands::add_info(app);
  commands::add_export(app);
  commands::add_sample(app);
  commands::add_shape(app);
  commands::add_scan(app);
  commands::add_trace(app);
  commands::add_compare(app);
  commands::add_evaluate(app);
  commands::add_bench(app);
  commands::add_render(app);
  commands::add_demo(app);
  commands::add_on_board(app);
  commands::add_calibrate(app);
  commands::add_qualify(app);
}

}  // namespace

int main(int argc, char** argv) {
  keep_freed_memory();
  return isotouch::commands::run("isotouch", "Turns oriented points into a distance field that a haptic controller can touch.",
                                 add_commands, argc, argv);
}
