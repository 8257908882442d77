/// Numbers with units on the command line: "0.34mm", "0.8N/mm", or the plain number in the option's own unit.
#pragma once

#include <CLI/CLI.hpp>
#include <optional>
#include <string_view>
#include <vector>

#include "shared/settings_table.h"

namespace isotouch::commands {

struct UnitName {
  std::string_view name;
  double factor;  ///< this unit in the option's own unit
};

/// text      a decimal number, directly followed by the name of a unit or by nothing; no signs before, no spaces, nothing else
/// units     the option's own unit first
/// returns   the value in the option's own unit; nothing when the text is anything else
std::optional<double> parse_quantity(std::string_view text, const std::vector<UnitName>& units);

/// For `option->transform(...)`: replaces the text by the plain number; wrong texts and values outside [low, high] are wrong usage.
CLI::Validator quantity(std::vector<UnitName> units, double low, double high);

/// The same for a number of the table of settings: its unit, its range, and 0 where that means "unset".
CLI::Validator value_of(const SettingRow& row);

inline const std::vector<UnitName> kLength = {{"mm", 1.0}, {"um", 0.001}, {"cm", 10.0}, {"m", 1000.0}, {"in", 25.4}};
inline const std::vector<UnitName> kStiffness = {{"N/mm", 1.0}, {"N/m", 0.001}};

}  // namespace isotouch::commands
