/// Options of a depth camera, for commands that read a scan.
#pragma once

#include <CLI/CLI.hpp>
#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "host/board_commands/number_in.h"
#include "host/board_commands/number_list.h"
#include "host/cloud/computable.h"
#include "host/cloud/depth_image.h"
#include "host/cloud/source_file.h"

namespace isotouch::commands {

struct CameraOptions {
  std::vector<double> intrinsics;  ///< fx, fy, cx, cy; empty: not given
  double units_per_metre = 1000;

  void add_to(CLI::App& command) {
    CLI::Option* given = command.add_option("--intrinsics", intrinsics, "the depth camera's focal lengths and principal point, pixels");
    take_numbers(given, "FX,FY,CX,CY");
    command.add_option("--depth-scale", units_per_metre, "what one metre is in the depth image; TUM's data has 5000")
        ->needs(given)
        ->check(number_in(1e-6, 1e9))
        ->capture_default_str();
  }
  std::optional<cloud::DepthCamera> camera() const {
    if (intrinsics.empty()) return std::nullopt;
    const bool finite = std::all_of(intrinsics.begin(), intrinsics.end(), [](double value) { return std::isfinite(value); });
    if (!finite || intrinsics[0] <= 0 || intrinsics[1] <= 0)
      throw CLI::ValidationError("--intrinsics", "the four numbers must be finite, and the focal lengths FX and FY above 0");
    return cloud::DepthCamera{intrinsics[0], intrinsics[1], intrinsics[2], intrinsics[3], units_per_metre};
  }
};

/// --viewpoint X,Y,Z, or --no-viewpoint
///
/// sensor    stays alive as long as the command
inline void add_viewpoint(CLI::App& command, cloud::SensorOptions& sensor, const std::string& about) {
  CLI::Option* place = command.add_option_function<std::vector<double>>(
      "--viewpoint",
      [&sensor](const std::vector<double>& numbers) {
        const Eigen::Vector3d at(numbers[0], numbers[1], numbers[2]);
        if (!cloud::is_computable(at)) throw CLI::ValidationError("--viewpoint", "its three numbers must lie within ±1e100");
        sensor.viewpoint = at;
      },
      about);
  take_numbers(place, "X,Y,Z");
  command.add_flag("--no-viewpoint", sensor.ignores_viewpoint, "ignore what a file itself says of the sensor's place")->excludes(place);
}

}  // namespace isotouch::commands
