/// The sub-commands that `isotouchctl` has, and `isotouch`, too, one file each. A command adds itself to the parser; its callback does the work.
///
/// Bad input is thrown as InputError (exit 1), a comparison that failed as ComparisonFailed (exit 3), what came to less than was asked for but is kept
/// as EndedEarly (exit 4), what nobody can judge as CannotBeJudged (exit 125), what no other commit can mend as EndsBisection (exit 128). Wrong usage
/// (exit 2) is the parser's, or thrown as UsageError where only the command itself can see it.
/// With --json a command prints one object on standard output and nothing else there; all remarks go to standard error.
#pragma once

#include <CLI/CLI.hpp>
#include <filesystem>
#include <functional>
#include <memory>
#include <stdexcept>
#include <string>

#include "host/trace/replay.h"

namespace isotouch::commands {

class ComparisonFailed : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

class EndedEarly : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Of what `git bisect run` tries: skip this one.
class CannotBeJudged : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// `git bisect run` stops.
class EndsBisection : public std::runtime_error {
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

/// Makes the renderer that feels a mesh with the exact god-object: for `replay`.
///
/// field     stays alive as long as the renderer
/// mesh      the file
/// trace     that is felt; its patches are read from the file beside it
/// fails     InputError: no closed mesh; as trace::read_patches
using MakeGodObject =
    std::function<std::unique_ptr<trace::Renderer>(const FieldView& field, const std::filesystem::path& mesh, const trace::Trace& trace)>;

/// god_object     none: the command knows no such renderer, because what measures fields stays on the desk
void add_replay(CLI::App& app, const MakeGodObject& god_object = nullptr);

/// All of them but those of `trace`.
void add_on_board(CLI::App& app, const MakeGodObject& god_object = nullptr);

}  // namespace isotouch::commands
