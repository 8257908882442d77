/// Several numbers as one value on the command line, such as a place: "1,2,3" or "1 2 3".
#pragma once

#include <CLI/CLI.hpp>
#include <algorithm>
#include <string>

namespace isotouch::commands {

/// Lets an option take as many numbers as it has names, with commas or spaces between them, and nothing behind them.
///
/// option    of a vector of numbers
/// names     "X,Y,Z": what `--help` shows
inline CLI::Option* take_numbers(CLI::Option* option, const std::string& names) {
  const auto count = 1 + std::count(names.begin(), names.end(), ',');
  return option->expected(static_cast<int>(count))->type_name(names)->delimiter(',')->allow_extra_args(false);
}

/// The names of such an option; empty: it is none.
inline std::string number_names(const CLI::Option& option) {
  const std::string type = option.get_type_name(), names = type.substr(0, type.find(':'));
  return names.find(',') == std::string::npos ? std::string() : names;
}

}  // namespace isotouch::commands
