/// How `--help` looks: one column of options, one of what they mean, with ranges, choices and defaults in words.
#pragma once

#include <CLI/CLI.hpp>
#include <string>

namespace isotouch::commands {

class HelpFormatter : public CLI::Formatter {
 public:
  /// A line of at most `kWidth` columns for what fits into one, and lines below it for the rest.
  std::string make_option(const CLI::Option* option, bool is_positional) const override;
  std::string make_subcommand(const CLI::App* command) const override;

 private:
  static constexpr std::size_t kWidth = 100;
  static constexpr std::size_t kNames = 28;  ///< columns of the names

  static std::string two_columns(const std::string& name, const std::string& text);
};

}  // namespace isotouch::commands
