/// The one table of settings: name, unit, range, default and meaning of each. Reading, printing and the manual come from it.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>

#include "firmware/settings/settings.h"

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
  std::string_view otherwise;  ///< what holds when an optional one is left out
  bool live = false;           ///< may change while it is felt
};

/// In the order in which they are printed; a section's settings stand together.
std::span<const Setting> table();

/// nullptr: there is no such setting
const Setting* find(std::string_view section, std::string_view name);

/// The file in which every setting stands with its default, commented by unit, range and meaning. Reading it changes nothing.
std::string default_file();

}  // namespace isotouch::settings
