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

}  // namespace isotouch::commands
