/// Force over time, beside another run or the exact answer where there is one: the paper's Fig. 9.
#pragma once

#include <Eigen/Core>
#include <string>
#include <utility>
#include <vector>

#include "host/view/picture.h"

namespace isotouch::view {

/// Drawn by its magnitude.
struct ForceCurve {
  std::string label;
  std::vector<double> time_s;          ///< at equal steps from 0
  std::vector<Eigen::Vector3d> force;  ///< N, as many
};

struct ForceOptions {
  int width = 960, height = 720;
  std::string title = {};
  std::vector<std::pair<double, double>> contacts = {};  ///< from when to when, s; shaded
  /// At each step of the curve, or none; the last one holds as long as another curve lasts. A line, or in words where one is far away.
  std::vector<double> limits_n = {};
  std::string difference = "difference to the exact answer";
};

/// The length of the difference of two forces, in millinewtons, as long as both last.
std::vector<double> force_differences(const ForceCurve& felt, const ForceCurve& beside);

/// With another curve a second plot shows `force_differences`.
///
/// beside    of the same step; nullptr: there is none
Picture force_picture(const ForceCurve& felt, const ForceCurve* beside, const ForceOptions& options);

}  // namespace isotouch::view
