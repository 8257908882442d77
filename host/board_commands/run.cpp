#include "host/board_commands/run.h"

#include <algorithm>
#include <csignal>
#include <cstdio>
#include <exception>
#include <memory>
#include <new>
#include <regex>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

#include "host/board_commands/choice.h"
#include "host/board_commands/commands.h"
#include "host/board_commands/every_option.h"
#include "host/board_commands/help_formatter.h"
#include "host/board_commands/number_list.h"
#include "host/error.h"
#include "host/link/words.h"
#include "packaging/manual/command_tree.h"
#include "shared/files/nearest_name.h"
#include "shared/files/standard_descriptors.h"
#include "shared/files/version_text.h"
#include "shared/printable.h"

namespace isotouch::commands {

namespace {

enum ExitCode : int {
  kDone = 0,
  kBadInput = 1,
  kWrongUsage = 2,
  kComparisonFailed = 3,
  kEndedEarly = 4,
  kCannotBeJudged = 125,
  kEndsBisection = 128
};

/// What a sentence quotes from a file or an argument may hold what a terminal must not get.
int complain(const char* program, ExitCode code, std::string sentence) {
  make_printable(sentence, '?');
  std::fprintf(stderr, "%s: %s\n", program, sentence.c_str());
  return code;
}

/// The commands of each task, in the order in which a person meets them.
struct Task {
  const char* name;
  std::vector<const char*> commands;
};

const std::vector<Task>& tasks() {
  static const std::vector<Task> all = {
      {"Build and judge a field",
       {"demo", "shape", "build", "info", "sample", "export", "render", "plot", "view", "evaluate", "compare", "bench"}},
      {"Run a controller",
       {"upload", "stream", "fields", "status", "latency", "watch", "set", "stop", "resume", "calibrate", "qualify", "fleet"}},
      {"Record and replay", {"record", "replay", "trace", "scan", "farm"}}};
  return all;
}

/// nullptr: there is none
template <class App>
App* find_command(App& app, const std::string& name) {
  for (auto* command : app.get_subcommands(nullptr)) {
    if (command->check_name(name)) return command;
  }
  return nullptr;
}

void group_by_task(CLI::App& app) {
  for (const Task& task : tasks()) {
    for (const char* name : task.commands) {
      if (CLI::App* command = find_command(app, name)) command->group(task.name);
    }
  }
}

/// `git bisect run` takes 1 to 127 for a bad commit, and stops for what is above: wrong usage says nothing about a commit.
bool ends_bisection(int argc, char** argv) {
  return argc > 2 && std::string_view(argv[1]) == "farm" && std::string_view(argv[2]) == "bisect";
}

std::string no_such(const std::string& word, const std::string& meant, const std::string& command) {
  const std::string known = command + " --help lists them";
  return std::string("there is no ") + (word.starts_with("--") ? "option" : "command") + " '" + word + "'; " +
         (meant.empty() ? known : "did you mean '" + meant + "'? " + known);
}

/// A word that no command or option is called, and what was probably meant; empty where all are known.
std::string unknown_word(const CLI::App& app, int argc, char** argv) {
  const CLI::App* command = &app;
  std::string said;  // the commands so far
  for (int i = 1; i < argc; ++i) {
    const std::string word = std::string(argv[i]).substr(0, std::string(argv[i]).find('='));
    if (!word.starts_with("-") && command->get_positionals_at_end()) break;  // what follows may be another program's
    std::vector<std::string> names;
    if (word.starts_with("--")) {
      for (const CLI::Option* option : command->get_options()) {
        for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
      }
    } else if (word.starts_with("-") || command->get_subcommands(nullptr).empty()) {
      continue;
    } else {
      for (const CLI::App* known : command->get_subcommands(nullptr)) {
        names.push_back(known->get_name());
      }
    }
    if (std::find(names.begin(), names.end(), word) != names.end()) {
      if (!word.starts_with("--")) command = find_command(*command, word), said.append(" ").append(command->get_name());
      continue;
    }
    return no_such(word, files::nearest_name(word, names), app.get_name() + said);
  }
  return {};
}

/// What the parser says in words of its own, for people; empty where its own are clear.
std::string in_words(const CLI::App& app, const CLI::ParseError& error) {
  const std::string said = error.what();
  static const std::regex excluding("(\\S+) excludes (\\S+)"), named("--[a-z0-9-]+");
  std::smatch found;
  if (error.get_name() == "ExcludesError" && std::regex_match(said, found, excluding))
    return "give " + found[1].str() + " or " + found[2].str() + ", not both";
  if (error.get_name() != "ArgumentMismatch" && error.get_name() != "ConversionError") return {};
  if (!std::regex_search(said, found, named)) return {};
  const CLI::App* command = &app;
  while (!command->get_subcommands().empty()) command = command->get_subcommands().front();
  const CLI::Option* option = command->get_option_no_throw(found.str());
  const std::string names = option == nullptr ? "" : number_names(*option);
  if (names.empty()) return {};
  return found.str() + " takes " + std::to_string(1 + std::count(names.begin(), names.end(), ',')) + " numbers, " + names +
         ", with commas or spaces between them";
}

/// Does what the command line asks.
int answer(const char* program, const char* about, void (*add)(CLI::App& app), int argc, char** argv) {
  CLI::App app{about, program};
  app.set_version_flag("--version", files::version_text(program), "print version, commit, formats and compiler");
  app.footer("Exit codes: 0 done, 1 bad input, 2 wrong usage, 3 a comparison failed, 4 ended early; what was done until then is kept.");
  app.formatter(std::make_shared<HelpFormatter>());
  app.require_subcommand(1);
  add(app);  // last: a sub-command takes over what is said before it is made
  check_every_option(app);
  group_by_task(app);
  if (manual::is_asked_for(argc, argv)) return manual::print_command(app, ""), kDone;
  try {
    app.parse(argc, argv);
    return kDone;
  } catch (const CLI::ParseError& e) {
    if (e.get_exit_code() == 0) return app.exit(e);
    const std::string unknown = unknown_word(app, argc, argv);
    const ExitCode wrong = ends_bisection(argc, argv) ? kEndsBisection : kWrongUsage;
    if (!unknown.empty()) return complain(program, wrong, unknown);
    if (const std::string clear = in_words(app, e); !clear.empty()) return complain(program, wrong, clear);
    return app.exit(e), wrong;
  } catch (const ComparisonFailed& e) {
    return complain(program, kComparisonFailed, e.what());
  } catch (const EndedEarly& e) {
    return complain(program, kEndedEarly, e.what());
  } catch (const CannotBeJudged& e) {
    return complain(program, kCannotBeJudged, e.what());
  } catch (const EndsBisection& e) {
    return complain(program, kEndsBisection, e.what());
  } catch (const UsageError& e) {
    return complain(program, ends_bisection(argc, argv) ? kEndsBisection : kWrongUsage, e.what());
  } catch (const InputError& e) {
    return complain(program, kBadInput, e.what());
  } catch (const std::bad_alloc&) {
    return complain(program, kBadInput, "not enough memory for this input; a field with a larger --voxel or a smaller --grid takes less");
  } catch (const std::system_error& e) {
    if (e.code() != std::errc::resource_unavailable_try_again) return complain(program, kBadInput, e.what());
    return complain(program, kBadInput,
                    "the system starts no more threads; end other programs, or raise its limit of processes (ulimit -u)");
  } catch (const std::exception& e) {
    return complain(program, kBadInput, e.what());
  }
}

}  // namespace

int run(const char* program, const char* about, void (*add)(CLI::App& app), int argc, char** argv) {
  files::occupy_standard_descriptors();
  std::signal(SIGXFSZ, SIG_IGN);  // the write says that the file grows beyond the limit (ulimit -f)
  link::tool_name() = program;
  const int code = answer(program, about, add, argc, argv);
  if (std::fflush(stdout) == 0 && std::ferror(stdout) == 0) return code;
  if (code != kDone && code != kComparisonFailed && code != kEndedEarly) return code;  // it has been said already that there is no result
  return complain(program, kBadInput, "standard output cannot be written to its end; free space, or write somewhere else");
}

}  // namespace isotouch::commands
