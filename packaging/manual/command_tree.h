/// Prints the commands and options of a program as text. packaging/manual/write_manual makes the manual page and the completion of the shells from it.
///
///     command TAB path TAB description TAB footer                                      the program has an empty path; "trace show" is a path
///     option TAB names TAB type TAB default TAB "required" or nothing TAB description   of the command above; no type: a flag; without "-": positional
///
/// In a field, a line's end is written "\n", a backslash "\\", and a tab as a space.
///
/// real time   no: before the program does anything else
#pragma once

#include <CLI/CLI.hpp>
#include <cstdio>
#include <cstring>
#include <initializer_list>
#include <string>

namespace isotouch::manual {

/// One line on standard output.
inline void print_fields(std::initializer_list<std::string> fields) {
  const char* before = "";
  for (const std::string& field : fields) {
    std::fputs(before, stdout);
    for (const char c : field) {
      if (c == '\n' || c == '\\')
        std::fputs(c == '\n' ? "\\n" : "\\\\", stdout);
      else
        std::putchar(c == '\t' ? ' ' : c);
    }
    before = "\t";
  }
  std::putchar('\n');
}

/// A command, its options, and the commands below it.
///
/// path      names of the commands that lead to it, with spaces between; empty for the program itself
inline void print_command(const CLI::App& command, const std::string& path) {
  print_fields({"command", path, command.get_description(), command.get_footer()});
  for (const CLI::Option* option : command.get_options()) {
    const bool takes_value = option->get_type_size() != 0 && option->get_expected_max() != 0;
    print_fields({"option", option->get_positional() ? option->get_name(true) : option->get_name(false, true),
                  takes_value ? option->get_type_name() : "", option->get_default_str(), option->get_required() ? "required" : "",
                  option->get_description()});
  }
  for (const CLI::App* below : command.get_subcommands(nullptr))
    print_command(*below, path + (path.empty() ? "" : " ") + below->get_name());
}

/// Is --command-tree the only argument? Only a build uses this option, so no help text lists it.
inline bool is_asked_for(int argc, char** argv) { return argc == 2 && std::strcmp(argv[1], "--command-tree") == 0; }

}  // namespace isotouch::manual
