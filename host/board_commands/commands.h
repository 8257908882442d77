/// The sub-commands that `isotouchctl` has, and `isotouch`, too, one file each. A command adds itself to the parser; its callback does the work.
///
/// Bad input is thrown as InputError (exit 1), a comparison that failed as ComparisonFailed (exit 3), what came to less than was asked for but is kept
/// as EndedEarly (exit 4); wrong usage is the parser's (exit 2).
/// With --json a command prints one object on standard output and nothing else there; all remarks go to standard error.
#pragma once

#include <CLI/CLI.hpp>
#include <stdexcept>
#include <string>

namespace isotouch::commands {

class ComparisonFailed : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

class EndedEarly : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

void add_status(CLI::App& app);
void add_latency(CLI::App& app);
void add_watch(CLI::App& app);
void add_upload(CLI::App& app);
void add_fields(CLI::App& app);
void add_set(CLI::App& app);
void add_record(CLI::App& app);
void add_stop(CLI::App& app);
void add_resume(CLI::App& app);
void add_replay(CLI::App& app);

/// All of them but those of `trace`.
void add_on_board(CLI::App& app);

}  // namespace isotouch::commands
