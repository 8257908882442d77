#include "host/field/make_grid.h"

#include <cmath>
#include <string>

#include "host/field/does_not_fit.h"

namespace isotouch::field {

namespace {
double rounded(double value) {
  constexpr double kScale = 1 << 20;
  return std::floor(value * kScale + 0.5) / kScale;
}
}  // namespace

Grid make_grid(const Eigen::Vector3d& low, const Eigen::Vector3d& high, double edge, double margin) {
  constexpr double kMaxSize = 4096;
  Grid grid;
  grid.edge = rounded(edge);
  if (!(grid.edge >= 1.0 / 64 && grid.edge <= 16)) {
    throw DoesNotFit("a voxel of " + std::to_string(edge) + " mm is not possible, the format holds 1/64 to 16 mm",
                     "choose another --voxel or --grid");
  }
  for (int axis = 0; axis < 3; ++axis) {
    const double size = std::ceil((high[axis] - low[axis]) / grid.edge + 2 * margin) + 1;
    if (!(size <= kMaxSize)) {
      throw DoesNotFit(
          "the grid would have " + std::to_string(static_cast<long long>(size)) + " samples along one axis, at most 4096 are possible",
          "choose a larger --voxel or a smaller --grid");
    }
    grid.size[axis] = static_cast<int>(size);
    grid.origin[axis] = rounded((low[axis] + high[axis] - grid.edge * (size - 1)) / 2);
  }
  return grid;
}

Grid exact_grid(Grid grid) {
  grid.edge = rounded(grid.edge);
  grid.origin = grid.origin.unaryExpr(&rounded);
  return grid;
}

}  // namespace isotouch::field
