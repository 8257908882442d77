/// `isotouch evaluate --dirty`: what dirty scans become, and whether the tool knows it.
#pragma once

#include <string>

namespace isotouch::commands {

/// Prints one row a scan and a kind of dirt; returns how many builds were wrong and called plausible.
///
/// only      a part of a row's names, to measure a part of the table; empty = all
std::size_t print_dirty(const std::string& only, bool json);

}  // namespace isotouch::commands
