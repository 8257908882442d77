/// The settings file: where each setting stands in it, and in which unit a person writes it. What decides how device and field behave takes its name, range
/// and meaning from `shared/settings_table.h`; what only the program knows stands here alone. Reading, printing and the manual come from this table.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>

#include "firmware/settings/settings.h"
#include "shared/tick_settings.h"

namespace isotouch::settings {

/// Where the value lives, which also says of what kind it is.
using Member = std::variant<double Settings::*, std::optional<double> Settings::*, int Settings::*, bool Settings::*,
                            std::string Settings::*, std::array<double, 3> Settings::*>;

struct Setting {
  std::string_view section;
  std::string_view name;
  Member member;
  std::string_view unit;  ///< empty: none
  double low = 0, high = 0;
  std::string_view choices;  ///< of a text, separated by '|'; empty: any text
  std::string_view meaning;
  std::string_view otherwise;             ///< what holds when an optional one is left out
  TickSetting live = TickSetting::kNone;  ///< which setting of the tick it changes while it is felt; kNone: only at a start
};

/// In the order in which they are printed; a section's settings stand together.
std::span<const Setting> table();

/// nullptr: there is no such setting
const Setting* find(std::string_view section, std::string_view name);

/// A number as a person reads it, or in another format of printf for one double.
std::string number(double value, const char* format = "%.10g");

/// The settings that differ from their default: "section.name = value" each, by newlines, without characters that a terminal must not get.
std::string different(const Settings& settings);

/// One number for all settings together, for people and reports: equal numbers mean the same settings, but for the name of the recording that carries it.
std::uint64_t checksum(const Settings& settings);

/// The file in which every setting stands with its default, commented by unit, range and meaning. Reading it changes nothing.
std::string default_file();

}  // namespace isotouch::settings
