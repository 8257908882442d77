#include "host/commands/run.h"

#include <cstdio>
#include <exception>
#include <new>

#include "host/commands/commands.h"
#include "host/error.h"

namespace isotouch::commands {

namespace {

enum ExitCode : int { kDone = 0, kBadInput = 1, kWrongUsage = 2, kComparisonFailed = 3, kEndedEarly = 4 };

int complain(const char* program, ExitCode code, const char* sentence) {
  std::fprintf(stderr, "%s: %s\n", program, sentence);
  return code;
}

}  // namespace

int run(const char* program, const char* about, void (*add)(CLI::App& app), int argc, char** argv) {
  CLI::App app{about};
  app.footer("Exit codes: 0 done, 1 bad input, 2 wrong usage, 3 a comparison failed, 4 ended early and what came is kept.");
  app.require_subcommand(1);
  add(app);  // last: a sub-command takes over what is said before it is made
  try {
    app.parse(argc, argv);
    return kDone;
  } catch (const CLI::ParseError& e) {
    return app.exit(e) == 0 ? kDone : kWrongUsage;
  } catch (const ComparisonFailed& e) {
    return complain(program, kComparisonFailed, e.what());
  } catch (const EndedEarly& e) {
    return complain(program, kEndedEarly, e.what());
  } catch (const InputError& e) {
    return complain(program, kBadInput, e.what());
  } catch (const std::bad_alloc&) {
    return complain(program, kBadInput, "not enough memory for this input; a field with a larger --voxel or a smaller --grid takes less");
  } catch (const std::exception& e) {
    return complain(program, kBadInput, e.what());
  }
}

}  // namespace isotouch::commands
