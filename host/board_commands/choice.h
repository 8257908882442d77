/// Names on the command line: one of a list, and the one that was probably meant.
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace isotouch::commands {

/// The name that is nearest to what was typed, by the number of letters to insert, remove, replace or swap with their neighbour; empty where none is
/// near, which is more than a third of what was typed, and more than one letter.
std::string nearest_name(std::string_view typed, const std::vector<std::string>& names);

/// For `option->check(...)`: anything else than one of these names is wrong usage.
CLI::Validator one_of(std::vector<std::string> names);

}  // namespace isotouch::commands
