#include "host/field/rounding.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdio>

namespace isotouch::field {

namespace {

constexpr std::size_t kAsked = 2000;    // points, at most
constexpr double kUneven = 0.02;        // of a step: what the sums of decimals leave
constexpr double kAlike = 0.95;         // of the points: rounding leaves half
constexpr std::size_t kOfEachStep = 4;  // points at least: fewer, and the differences say nothing
constexpr double kMostUneven = 0.02;    // of the points: a few that were added to a rounded scan
constexpr double kFrequent = 0.05;      // of the differences between neighbouring values

/// Are all but a few of the values whole steps from one of them?
bool are_even(const std::vector<double>& values, double from, double step) {
  const auto is_uneven = [&](double value) {
    const double steps = (value - from) / step;
    return std::abs(steps - std::round(steps)) > kUneven;
  };
  return static_cast<double>(std::count_if(values.begin(), values.end(), is_uneven)) <= kMostUneven * static_cast<double>(values.size());
}

double step_along(const std::vector<Eigen::Vector3d>& positions, int axis) {
  std::vector<double> values;
  const std::size_t every = 1 + positions.size() / kAsked;
  for (std::size_t i = 0; i < positions.size(); i += every) values.push_back(positions[i][axis]);
  std::sort(values.begin(), values.end());
  std::size_t different = 0;
  std::vector<double> repeated;  // the others may be those of a few points that were added to a rounded scan
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (i > 0 && values[i] == values[i - 1]) continue;
    ++different;
    if (i + 1 < values.size() && values[i] == values[i + 1]) repeated.push_back(values[i]);
  }
  if (repeated.size() < 2 || kOfEachStep * different > values.size()) return 0.0;

  // The least of the frequent differences that fits: where steps are left out, a larger one may be the commonest.
  std::vector<std::array<double, 2>> steps;  // and where they begin
  for (std::size_t i = 1; i < repeated.size(); ++i) steps.push_back({repeated[i] - repeated[i - 1], repeated[i - 1]});
  std::sort(steps.begin(), steps.end());
  for (std::size_t first = 0, end = 0; first < steps.size(); first = end) {
    while (end < steps.size() && steps[end][0] <= (1.0 + kUneven) * steps[first][0]) ++end;
    if (static_cast<double>(end - first) < kFrequent * static_cast<double>(steps.size())) continue;
    const auto& [length, from] = steps[first + (end - first) / 2];
    if (are_even(values, from, length)) return length;
  }
  return 0.0;
}

/// Do the points lie in the middle of a lattice's edges, or of its faces? There as many coordinates of each are odd; rounding leaves every number of them.
bool are_middles(const std::vector<Eigen::Vector3d>& positions, double step) {
  const auto is_odd = [&](const Eigen::Vector3d& position) {
    const double steps = ((position - positions.front()) / step).array().round().sum();
    return std::fmod(steps, 2.0) != 0.0;
  };
  const auto odd = static_cast<double>(std::count_if(positions.begin(), positions.end(), is_odd));
  const double all = static_cast<double>(positions.size());
  return std::max(odd, all - odd) > kAlike * all;
}

}  // namespace

double rounding_step(const std::vector<Eigen::Vector3d>& positions) {
  const double step = std::min({step_along(positions, 0), step_along(positions, 1), step_along(positions, 2)});
  return step > 0.0 && are_middles(positions, step) ? 2.0 * step : step;
}

AxisStep coarsest_axis(const std::vector<Eigen::Vector3d>& positions) {
  AxisStep coarsest;
  for (int axis = 0; axis < 3; ++axis) {
    const double step = step_along(positions, axis);
    if (step > coarsest.step) coarsest = {axis, step};
  }
  return coarsest;
}

double float_step(const std::vector<Eigen::Vector3d>& positions) {
  float farthest = 0.0F;
  for (const Eigen::Vector3d& position : positions) {
    const Eigen::Vector3f rounded = position.cast<float>();
    if (rounded.cast<double>() != position) return 0.0;
    farthest = std::max(farthest, rounded.cwiseAbs().maxCoeff());
  }
  return static_cast<double>(farthest - std::nextafter(farthest, 0.0F));
}

std::string floats_too_coarse(double voxels) {
  std::array<char, 200> text{};
  std::snprintf(text.data(), text.size(),
                "the coordinates are so far from the origin that 32-bit floats have steps of %.1f voxels there; shift the scan to a local "
                "origin, or save it with doubles",
                voxels);
  return text.data();
}

}  // namespace isotouch::field
