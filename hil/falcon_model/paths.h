/// Where a hand wants to be: scripted motions, and those of a trace. Workspace frame, mm: as the device's, with the origin in the middle of its reach.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "hil/falcon_model/vector.h"

namespace isotouch::falcon_model {

/// The wanted place, mm, so many ms after the path's begin; continuous, and held still after its end where it has one.
using Path = std::function<Vector(double ms)>;

/// The scripted motions' names:
///   rest     stays in the middle
///   press    in from the front at 25 mm/s, through a ball of 35 mm to 10 mm before its middle, a rest, and back
///   stab     straight through from right to left and back, 45 mm to each side, at up to 1 m/s
///   tour     a sweep in and out of a ball of 33 mm, to 21 and 45 mm, that closes after 60 s
///   stroke   from side to side, 2 mm below the front of a ball of 35 mm
///   tremor   comes from the front, stays 3 mm below it and trembles 10 times a second, 0.5 mm around
std::vector<std::string> motion_names();

/// fails     std::invalid_argument: no motion is called so
Path scripted_path(const std::string& name);

/// The HIP positions of a trace file, linear between ticks, the last one held.
///
/// fails     std::runtime_error, a sentence: no trace, another major version, broken, or of encoder counts
Path recorded_path(const std::filesystem::path& file);

}  // namespace isotouch::falcon_model
