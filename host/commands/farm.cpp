/// isotouch farm: recordings replayed by many programs, in shards that any engine runs, and what differs since when.
#include <sys/wait.h>

#include <algorithm>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <memory>
#include <string>
#include <system_error>
#include <thread>
#include <vector>

#include "host/board_commands/interruption.h"
#include "host/board_commands/number_in.h"
#include "host/board_commands/output.h"
#include "host/commands/commands.h"
#include "host/error.h"
#include "host/farm/answer.h"
#include "host/farm/report.h"
#include "host/farm/share.h"
#include "host/files/whole_file.h"

namespace isotouch::commands {

namespace {

namespace fs = std::filesystem;

struct Addition {
  fs::path table;
  farm::Recording recording;

  void operator()() const {
    farm::Recording named = recording;
    if (named.name.empty()) named.name = named.trace.path.stem().string();
    farm::add_recording(table, named);
    std::fprintf(stderr, "%s: %s added\n", table.string().c_str(), named.name.c_str());
  }
};

/// The tables and the folder that `run` and `merge` work on.
struct Farm {
  fs::path recordings, programs, answers;

  void add_to(CLI::App& command) {
    command.add_option("RECORDINGS", recordings, "the table of recordings, as `isotouch farm add` makes it")->required();
    command.add_option("PROGRAMS", programs, "the table of programs: processor, commit, compiler, rung, command")->required();
    command.add_option("ANSWERS", answers, "the folder of answers, shared by all machines; made where there is none")->required();
  }
};

struct ShareOptions {
  Farm farm;
  farm::Share share;

  void operator()() const {
    if (share.shard >= share.shards)
      throw CLI::ValidationError(
          "--shard", "there is no shard " + std::to_string(share.shard) + " of " + std::to_string(share.shards) + "; the first is 0");
    const auto recordings = farm::read_recordings(farm.recordings);
    const auto programs = farm::read_programs(farm.programs);
    const Interruption interruption;
    farm::Share own = share;
    own.patience.may_go_on = [&] { return !interruption.has_come(); };
    const farm::ShareReport report = farm::run_share(recordings, programs, farm.answers, own);
    std::printf("tasks         %zu\nkept before   %zu\nreplayed      %zu\nfailed        %zu\n", report.tasks, report.kept, report.asked,
                report.failed);
    if (interruption.has_come()) throw EndedEarly("interrupted; the same command goes on from here");
    if (!report.changed.empty()) throw InputError(report.changed);
    if (report.failed > 0)
      throw InputError(std::to_string(report.failed) +
                       " tasks have no answer; isotouch farm merge says why, and the same command asks again");
  }
};

struct Merge {
  Farm farm;
  fs::path table, page;

  void operator()() const {
    if (!table.empty() && table == page) throw CLI::ValidationError("--html", "table and page cannot be the same file");
    std::error_code none;
    if (!fs::is_directory(farm.answers, none))
      throw InputError(farm.answers.string() + ": no folder of answers; isotouch farm run makes it");
    const auto recordings = farm::read_recordings(farm.recordings);
    const auto programs = farm::read_programs(farm.programs);
    const std::vector<farm::Row> rows = farm::merge(recordings, programs, farm.answers);
    write(table, farm::to_csv(rows));
    write(page, farm::to_html(rows));
    const farm::Counts counts = farm::count(rows);
    std::FILE* to = text_stream(table == "-" ? table : page);
    std::fprintf(to, "%zu recordings by %zu programs: %zu equal, %zu different, %zu failed, %zu missing\n", recordings.size(),
                 programs.size(), counts.equal, counts.differs, counts.failed, counts.missing);
    for (const farm::Change& change : farm::changes(rows))
      std::fprintf(to, "%s differs %s\n", change.recording->name.c_str(), farm::in_words(change).c_str());
    print_what_was_said(to, rows);
    if (counts.differs > 0) throw ComparisonFailed("answers that differ: " + std::to_string(counts.differs));
    if (counts.failed + counts.missing > 0)
      throw EndedEarly("answers that are not known: " + std::to_string(counts.failed + counts.missing) +
                       "; isotouch farm run asks for them");
  }

 private:
  static void write(const fs::path& file, const std::string& text) {
    if (!file.empty()) write_file(file, text);
  }
  /// Why something failed, or which answers contradict.
  static void print_what_was_said(std::FILE* to, const std::vector<farm::Row>& rows) {
    constexpr int kMaxLines = 10;
    int lines = 0;
    for (const farm::Row& row : rows) {
      if (!row.answer || row.answer->said.empty() || ++lines > kMaxLines) continue;
      std::fprintf(to, "%s %s on %s at %s: %s\n", row.recording->name.c_str(), farm::name_of(row.answer->outcome),
                   row.program->processor.c_str(), row.program->commit.c_str(), row.answer->said.c_str());
    }
    if (lines > kMaxLines) std::fprintf(to, "and %d more; the page lists all\n", lines - kMaxLines);
  }
};

struct Bisect {
  farm::Recording recording;
  std::string build;
  std::vector<std::string> command;
  farm::Patience patience{};

  void operator()() const {
    try {
      judge();
    } catch (const ComparisonFailed&) {
      throw;
    } catch (const EndsBisection&) {
      throw;
    } catch (const std::exception& error) {
      throw CannotBeJudged(error.what());
    }
  }

 private:
  void judge() const {
    for (const std::string& word : {recording.trace.path.string(), command.front()})
      if (word.starts_with("-")) throw EndsBisection(word + " stands behind FIELD; put options before it");
    const auto end_if_interrupted = [&](bool is_interrupted) {
      if (is_interrupted) throw EndsBisection("interrupted; start git bisect run again to go on from here");
    };
    const int built = build.empty() ? 0 : std::system(("exec >&2; " + build).c_str());
    end_if_interrupted(is_by_ctrl_c(built));
    if (built != 0) throw CannotBeJudged("the build failed");
    const auto end_if_missing = [](const fs::path& file) {
      std::error_code none;
      if (fs::status(file, none).type() == fs::file_type::not_found)
        throw EndsBisection(file.string() + ": it is not there; keep the recording where no commit takes it away");
    };
    end_if_missing(recording.field.path);
    end_if_missing(recording.trace.path);
    const Interruption interruption;
    farm::Patience own = patience;
    own.may_go_on = [&] { return !interruption.has_come(); };
    const farm::Recording named = read_recording();
    const farm::Answer answer = farm::ask(named, {{}, {}, {}, {}, command, {}, {}}, own);
    end_if_interrupted(interruption.has_come());
    if (answer.outcome == farm::Answer::Outcome::kFailed) throw CannotBeJudged(answer.said);
    if (answer.outcome == farm::Answer::Outcome::kDiffers) {
      throw ComparisonFailed(answer.first_different ? "tick " + std::to_string(*answer.first_different) + " differs"
                                                    : "the hash is " + answer.hash + " instead of " + named.expected);
    }
    std::printf("equal, hash %s\n", answer.hash.c_str());
  }
  /// The files are the same at each commit, and so is what is wrong with them.
  farm::Recording read_recording() const {
    try {
      return farm::as_recorded(recording);
    } catch (const std::exception& error) {
      throw EndsBisection(error.what());
    }
  }
  /// Of what std::system returned, which keeps Ctrl-C from this program as long as its shell runs.
  static bool is_by_ctrl_c(int status) {
    return (WIFSIGNALED(status) && WTERMSIG(status) == SIGINT) || (WIFEXITED(status) && WEXITSTATUS(status) == 128 + SIGINT);
  }
};

void add_timeout(CLI::App& command, farm::Patience& patience) {
  command.add_option("--timeout", patience.seconds, "seconds that a program may take; 0: as long as it wants")
      ->check(number_in(0, 1e9))
      ->capture_default_str();
}

template <class Options>
CLI::App* add_command(CLI::App& farm, const char* name, const char* about, const std::shared_ptr<Options>& options) {
  CLI::App* command = farm.add_subcommand(name, about);
  command->callback([options] { (*options)(); });
  return command;
}

void add_addition(CLI::App& farm) {
  auto options = std::make_shared<Addition>();
  CLI::App* command = add_command(farm, "add", "Add a recording, which must answer as recorded, to a table", options);
  command->add_option("RECORDINGS", options->table, "the table; made where there is none")->required();
  command->add_option("FIELD", options->recording.field.path, "the field (.itfi where a program reads nothing else)")->required();
  command->add_option("TRACE", options->recording.trace.path, "the recorded run (.trace)")->required();
  command->add_option("--name", options->recording.name, "its name in the table; by default the file's");
  command->add_option("--origin", options->recording.origin, "who or what moved the hand")->required();
}

void add_run(CLI::App& farm) {
  auto options = std::make_shared<ShareOptions>();
  CLI::App* command = add_command(farm, "run", "Ask for the answers that are not there yet", options);
  options->farm.add_to(*command);
  command->add_option("--shard", options->share.shard, "only this share of the tasks, counted from 0")->capture_default_str();
  command->add_option("--of", options->share.shards, "number of shares")->check(whole_number_in(1, 1000000000))->capture_default_str();
  add_timeout(*command, options->share.patience);
  options->share.jobs = std::max(1U, std::thread::hardware_concurrency());
  command->add_option("--jobs", options->share.jobs, "programs at once; by default one for each processor")
      ->check(whole_number_in(1, 4096));
}

void add_merge(CLI::App& farm) {
  auto options = std::make_shared<Merge>();
  CLI::App* command = add_command(farm, "merge", "Put all answers together: what differs, since which commit, on which processor", options);
  options->farm.add_to(*command);
  add_output(*command, "-o,--out", options->table, {&forms::kTable}, "also write a row for each answer");
  add_output(*command, "--html", options->page, {&forms::kPage}, "also write a page for a browser");
}

void add_bisect(CLI::App& farm) {
  auto options = std::make_shared<Bisect>();
  CLI::App* command =
      add_command(farm, "bisect",
                  "Judge the commit at hand for `git bisect run`: 0 equal, 3 different, 125 cannot be judged, 128 no commit can", options);
  command->add_option("FIELD", options->recording.field.path, "the field")->required();
  command->add_option("TRACE", options->recording.trace.path, "the recorded run")->required();
  command->add_option("PROGRAM", options->command, "the program that replays, and words before the names of field and trace")->required();
  command->add_option("--build", options->build, "the shell's command that builds the program; before FIELD");
  add_timeout(*command, options->patience);
  command->positionals_at_end();  // what looks like an option behind FIELD is the program's
}

}  // namespace

void add_farm(CLI::App& app) {
  CLI::App* command = app.add_subcommand("farm", "Replay recordings by many programs, on many machines, and find what differs");
  command->require_subcommand(1);
  add_addition(*command);
  add_run(*command);
  add_merge(*command);
  add_bisect(*command);
}

}  // namespace isotouch::commands
