#include "host/field/rounding.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

namespace isotouch::field {

namespace {

constexpr std::size_t kAsked = 2000;    // points, at most
constexpr double kUneven = 0.02;        // of a step: what the sums of decimals leave
constexpr double kAlike = 0.95;         // of the points: rounding leaves half
constexpr std::size_t kOfEachStep = 4;  // points at least: fewer, and the least difference says nothing

double step_along(const std::vector<Eigen::Vector3d>& positions, int axis) {
  std::vector<double> values;
  const std::size_t every = 1 + positions.size() / kAsked;
  for (std::size_t i = 0; i < positions.size(); i += every) values.push_back(positions[i][axis]);
  const std::size_t asked = values.size();
  std::sort(values.begin(), values.end());
  values.erase(std::unique(values.begin(), values.end()), values.end());
  if (values.size() < 2 || kOfEachStep * values.size() > asked) return 0.0;
  double step = std::numeric_limits<double>::max();
  for (std::size_t i = 1; i < values.size(); ++i) step = std::min(step, values[i] - values[i - 1]);
  const auto uneven = [&](double value) {
    const double steps = (value - values.front()) / step;
    return std::abs(steps - std::round(steps)) > kUneven;
  };
  return std::any_of(values.begin(), values.end(), uneven) ? 0.0 : step;
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
