#include "host/commands/quantities.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <string>
#include <utility>

namespace isotouch::commands {

namespace {

/// The shortest text that reads back as the same number.
std::string shortest(double value) {
  std::array<char, 32> text{};
  return {text.data(), std::to_chars(text.data(), text.data() + text.size(), value).ptr};
}

}  // namespace

std::optional<double> parse_quantity(std::string_view text, const std::vector<UnitName>& units) {
  if (text.empty() || (text.front() != '.' && (text.front() < '0' || text.front() > '9'))) return std::nullopt;
  double number = 0;
  const auto [rest, failure] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (failure != std::errc() || !std::isfinite(number)) return std::nullopt;
  const std::string_view name = text.substr(static_cast<std::size_t>(rest - text.data()));
  if (name.empty()) return number;
  const auto unit = std::find_if(units.begin(), units.end(), [&](const UnitName& known) { return known.name == name; });
  if (unit == units.end()) return std::nullopt;
  return number * unit->factor;
}

CLI::Validator quantity(std::vector<UnitName> units, double low, double high) {
  const std::string own(units.front().name);
  const std::string range = shortest(low) + own + " to " + shortest(high) + own;
  const auto convert = [units = std::move(units), range, low, high](std::string& text) -> std::string {
    const std::optional<double> value = parse_quantity(text, units);
    if (value && *value >= low && *value <= high) {
      text = shortest(*value);
      return {};
    }
    std::string names;
    for (const UnitName& unit : units) names += (names.empty() ? "" : ", ") + std::string(unit.name);
    return "'" + text + "' is not a value from " + range + "; units are " + names;
  };
  return {convert, range, "quantity"};
}

CLI::Validator value_of(const SettingRow& row) {
  std::string unit(row.unit);
  unit.erase(std::remove(unit.begin(), unit.end(), ' '), unit.end());
  const std::vector<UnitName> units = unit == "N/mm" ? kStiffness : std::vector<UnitName>{{row.unit, 1.0}};
  const std::string range = shortest(row.low) + unit + " to " + shortest(row.high) + unit + (row.zero_means_unset ? ", or 0" : "");
  const auto convert = [units, unit, range, row](std::string& text) -> std::string {
    const bool negative = row.low < 0 && !text.empty() && text.front() == '-';
    std::string_view digits = std::string_view(text).substr(negative ? 1 : 0);
    if (units.size() == 1 && !unit.empty() && digits.ends_with(unit)) digits.remove_suffix(unit.size());
    std::optional<double> value = parse_quantity(digits, units);
    if (value && negative) value = -*value;
    if (value && ((*value >= row.low && *value <= row.high) || (row.zero_means_unset && *value == 0))) {
      text = shortest(*value);
      return {};
    }
    return "'" + text + "' is not a value from " + range;
  };
  return {convert, range, std::string(row.name)};
}

}  // namespace isotouch::commands
