/// From a TOML file to settings. A key that is not in the table, a value of another kind or outside its range is refused, never ignored; so are settings that
/// contradict each other.
#pragma once

#include <string>
#include <string_view>

#include "firmware/settings/settings.h"
#include "shared/files/refusal.h"

namespace isotouch::settings {

/// text        the file's content
/// name        of the file, for complaints
/// settings    changed by what the file names; undefined content when refused
/// returns     file, line, what is wrong and what would be right
Refusal parse_settings(std::string_view text, const std::string& name, Settings& settings);

/// The same for a file of that name.
Refusal read_settings(const std::string& path, Settings& settings);

}  // namespace isotouch::settings
