/// Names on the command line: one of a list, and the one that was probably meant.
#pragma once

#include <CLI/CLI.hpp>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace isotouch::commands {

/// For `option->check(...)`: anything else than one of these names is wrong usage.
CLI::Validator one_of(std::vector<std::string> names);

/// The same for `option->transform(...)`: the names of an enumeration's values.
template <class Enum>
CLI::Validator one_of(const std::map<std::string, Enum>& values) {
  std::vector<std::string> names;
  for (const auto& [name, value] : values) names.push_back(name);
  const CLI::Validator known = one_of(std::move(names));
  const auto convert = [values, known](std::string& text) -> std::string {
    std::string wrong = known(text);
    if (wrong.empty()) text = std::to_string(static_cast<int>(values.at(text)));
    return wrong;
  };
  return {convert, known.get_description(), "one of"};
}

}  // namespace isotouch::commands
