/// `isotouch evaluate --dirty`: what dirty scans become, and whether the tool knows it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "host/evaluate/dirty_scan.h"

namespace isotouch::commands {

struct DirtyChoice {
  std::string only;                           ///< a part of a row's names, to measure a part of the table; empty = all
  std::vector<std::filesystem::path> meshes;  ///< closed; empty = our own objects
  std::uint64_t seed = 1;
  std::string
      beside;  ///< a command that turns a PLY of oriented points, its second to last argument, into a PLY mesh, its last; each kind of dirt gets
               ///< a second row, of that mesh; empty = none
};

/// A row for programs: no figure of a scan that was refused, and none that was not measured, is a number.
nlohmann::ordered_json to_json(const evaluate::DirtyRow& row);

/// Prints one row a scan and a kind of dirt; returns how many builds were wrong and called plausible.
///
/// fails     InputError: a mesh that cannot be read or is not closed
std::size_t print_dirty(const DirtyChoice& choice, bool json);

}  // namespace isotouch::commands
