/// Real numbers on the command line.
#pragma once

#include <CLI/CLI.hpp>
#include <sstream>
#include <string>

namespace isotouch::commands {

/// For `option->check(...)`: anything else than a number within these bounds is wrong usage. CLI::Range would take nan.
inline CLI::Validator number_in(double low, double high) {
  std::ostringstream range;
  range << low << " to " << high;
  const auto check = [low, high, bounds = range.str()](std::string& text) -> std::string {
    double value = 0;
    if (CLI::detail::lexical_cast(text, value) && value >= low && value <= high) return {};
    return "'" + text + "' is not a number from " + bounds;
  };
  return {check, range.str(), "number"};
}

}  // namespace isotouch::commands
