/// Numbers on the command line, within bounds.
#pragma once

#include <CLI/CLI.hpp>
#include <cstdint>
#include <sstream>
#include <string>

#include "shared/files/option_values.h"

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

/// The same of whole numbers that are not below zero.
inline CLI::Validator whole_number_in(std::uint64_t low, std::uint64_t high) {
  const auto check = [low, high](std::string& text) { return files::refusal_of_other_number(text, low, high); };
  return {check, std::to_string(low) + " to " + std::to_string(high), "whole number"};
}

}  // namespace isotouch::commands
