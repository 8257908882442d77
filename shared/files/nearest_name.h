/// "Did you mean …?": of names that somebody typed wrongly.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace isotouch::files {

/// The name that is nearest to what was typed, by the number of letters to insert, remove, replace or swap with their neighbour; empty where none is
/// near, which is more than a third of what was typed, and more than one letter.
std::string nearest_name(std::string_view typed, const std::vector<std::string>& names);

}  // namespace isotouch::files
