/// What a program's command line knows, as text: packaging/manual/write_manual makes the manual page and the shells' completion of it.
///
///     command TAB path TAB description TAB footer                                      the program has an empty path; "trace show" is a path
///     option TAB names TAB type TAB default TAB "required" or nothing TAB description   of the command above; no type: a flag; without "-": positional
///
/// In a text, a line's end is written "\n" and a backslash "\\".
#pragma once

#include <CLI/CLI.hpp>
#include <cstdio>
#include <cstring>
#include <initializer_list>
#include <string>

namespace isotouch::manual {

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

/// Does the command line ask for this, and nothing else? It is the word of a build, so no help names it.
inline bool is_asked_for(int argc, char** argv) { return argc == 2 && std::strcmp(argv[1], "--command-tree") == 0; }

}  // namespace isotouch::manual
