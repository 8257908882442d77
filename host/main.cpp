/// isotouch: from oriented points to a field that can be touched. One sub-command per file in commands/.
#include <CLI/CLI.hpp>
#include <cstdio>
#include <exception>
#include <new>

#ifdef __GLIBC__
#include <malloc.h>
#endif

#include "host/commands/commands.h"
#include "host/error.h"

namespace {

enum ExitCode : int { kDone = 0, kBadInput = 1, kWrongUsage = 2, kComparisonFailed = 3, kEndedEarly = 4 };

int complain(ExitCode code, const char* sentence) {
  std::fprintf(stderr, "isotouch: %s\n", sentence);
  return code;
}

/// Freed memory is kept for the next step, which wants as much: handed back, every page of it would have to be cleared and mapped again.
void keep_freed_memory() {
#ifdef __GLIBC__
  constexpr int kMegabyte = 1 << 20;
  mallopt(M_MMAP_THRESHOLD, 32 * kMegabyte);
  mallopt(M_TRIM_THRESHOLD, 256 * kMegabyte);
#endif
}

}  // namespace

int main(int argc, char** argv) {
  using namespace isotouch;
  keep_freed_memory();
  CLI::App app{"Turns oriented points into a distance field that a haptic controller can touch."};
  app.footer("Exit codes: 0 done, 1 bad input, 2 wrong usage, 3 a comparison failed, 4 ended early and what came is kept.");
  app.require_subcommand(1);
  commands::add_build(app);
  commands::add_info(app);
  commands::add_export(app);
  commands::add_shape(app);
  commands::add_scan(app);
  commands::add_trace(app);
  commands::add_replay(app);
  commands::add_compare(app);
  commands::add_evaluate(app);
  commands::add_bench(app);
  commands::add_render(app);
  commands::add_demo(app);
  commands::add_upload(app);
  commands::add_status(app);
  commands::add_latency(app);
  commands::add_watch(app);
  commands::add_calibrate(app);
  commands::add_fields(app);
  commands::add_record(app);
  commands::add_stop(app);
  commands::add_resume(app);
  commands::add_set(app);
  commands::add_qualify(app);
  try {
    app.parse(argc, argv);
    return kDone;
  } catch (const CLI::ParseError& e) {
    return app.exit(e) == 0 ? kDone : kWrongUsage;
  } catch (const commands::ComparisonFailed& e) {
    return complain(kComparisonFailed, e.what());
  } catch (const commands::EndedEarly& e) {
    return complain(kEndedEarly, e.what());
  } catch (const InputError& e) {
    return complain(kBadInput, e.what());
  } catch (const std::bad_alloc&) {
    return complain(kBadInput, "not enough memory for this input; use a larger --voxel or a smaller --grid");
  } catch (const std::exception& e) {
    return complain(kBadInput, e.what());
  }
}
