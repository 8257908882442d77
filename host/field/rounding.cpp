#include "host/field/rounding.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace isotouch::field {

namespace {

constexpr std::size_t kAsked = 2000;    // points, at most
constexpr double kUneven = 0.02;        // of a step: what the sums of decimals leave
constexpr double kAlike = 0.95;         // of the points: rounding leaves half
constexpr std::size_t kOfEachStep = 4;  // points at least: fewer, and the differences say nothing
constexpr double kMostUneven = 0.02;    // of the points: a few that were added to a rounded scan

/// The commonest of the differences between neighbouring values, and a value where one of these begins. Of equally common ones the least.
struct Step {
  double length = 0, from = 0;
};
Step commonest_step(const std::vector<double>& values) {
  std::vector<std::array<double, 2>> steps;  // and where they begin
  for (std::size_t i = 1; i < values.size(); ++i) steps.push_back({values[i] - values[i - 1], values[i - 1]});
  std::sort(steps.begin(), steps.end());
  Step best;
  std::size_t most = 0;
  for (std::size_t first = 0, end = 0; first < steps.size(); ++first) {
    while (end < steps.size() && steps[end][0] <= (1.0 + kUneven) * steps[first][0]) ++end;
    if (end - first <= most) continue;
    most = end - first;
    best = {steps[first + most / 2][0], steps[first + most / 2][1]};
  }
  return best;
}

double step_along(const std::vector<Eigen::Vector3d>& positions, int axis) {
  std::vector<double> values;
  const std::size_t every = 1 + positions.size() / kAsked;
  for (std::size_t i = 0; i < positions.size(); i += every) values.push_back(positions[i][axis]);
  const std::size_t asked = values.size();
  std::vector<double> different = values;
  std::sort(different.begin(), different.end());
  different.erase(std::unique(different.begin(), different.end()), different.end());
  if (different.size() < 2 || kOfEachStep * different.size() > asked) return 0.0;
  const Step step = commonest_step(different);
  const auto uneven = [&](double value) {
    const double steps = (value - step.from) / step.length;
    return std::abs(steps - std::round(steps)) > kUneven;
  };
  const auto count = static_cast<double>(std::count_if(values.begin(), values.end(), uneven));
  return count > kMostUneven * static_cast<double>(asked) ? 0.0 : step.length;
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

}  // namespace isotouch::field
