/// `isotouch evaluate --dirty`: what dirty scans become, and whether the tool knows it.
#pragma once

#include <string>

namespace isotouch::commands {

/// Prints one row a scan and a kind of dirt; returns how many builds were wrong and called plausible.
///
/// only      a part of a row's names, to measure a part of the table; empty = all
/// beside    a command that turns a PLY of oriented points, its second to last argument, into a PLY mesh, its last; each kind of dirt gets a second row,
///           of that mesh; empty = none
std::size_t print_dirty(const std::string& only, const std::string& beside, bool json);

}  // namespace isotouch::commands
