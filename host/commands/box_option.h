/// --box: the part of space that a live field covers.
#pragma once

#include <CLI/CLI.hpp>
#include <Eigen/Geometry>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "host/board_commands/number_list.h"
#include "host/cloud/computable.h"

namespace isotouch::commands {

/// box       stays alive as long as the command
inline void add_box(CLI::App& command, std::optional<Eigen::AlignedBox3d>& box, const std::string& about) {
  take_numbers(command.add_option_function<std::vector<double>>(
                   "--box",
                   [&box](const std::vector<double>& of) {
                     const Eigen::Vector3d a(of[0], of[1], of[2]), b(of[3], of[4], of[5]);
                     if (!cloud::is_computable(a) || !cloud::is_computable(b) || !((a - b).cwiseAbs().array() > 0.0).all())
                       throw CLI::ValidationError("--box", "its two corners must lie within ±1e100 and differ in every coordinate");
                     box.emplace(a.cwiseMin(b), a.cwiseMax(b));
                   },
                   about),
               "X,Y,Z,X,Y,Z");
}

}  // namespace isotouch::commands
