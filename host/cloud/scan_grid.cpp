#include "host/cloud/scan_grid.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>

#include "host/cloud/model.h"

namespace isotouch::cloud {
namespace {

using Eigen::Vector3d;

constexpr double kAlongSight = 0.9698;  // squared sine of 80 degrees

enum class Link { kNone, kJoined, kJump };

/// Does a surface lead from one place to the other, or does the line of sight?
Link link(const Vector3d& from, const Vector3d& to, const Vector3d& sensor) {
  const Vector3d way = to - from;
  const Vector3d sight = 0.5 * (from + to) - sensor;
  const double along = way.dot(sight);
  return along * along > kAlongSight * way.squaredNorm() * sight.squaredNorm() ? Link::kJump : Link::kJoined;
}

class Grid {
 public:
  Grid(const std::vector<Vector3d>& positions, const ScanGrid& grid)
      : positions_(positions), grid_(grid), rows_(grid.cells.size() / grid.columns) {}

  /// The normal of a cell that returned something, in the grid's winding and of any length; zero for an edge.
  Vector3d normal(std::size_t column, std::size_t row) const {
    const Vector3d& own = positions_[point(column, row)];
    const std::array<std::uint32_t, 4> around = {column + 1 < grid_.columns ? point(column + 1, row) : ScanGrid::kNoReturn,
                                                 row + 1 < rows_ ? point(column, row + 1) : ScanGrid::kNoReturn,
                                                 column > 0 ? point(column - 1, row) : ScanGrid::kNoReturn,
                                                 row > 0 ? point(column, row - 1) : ScanGrid::kNoReturn};
    std::array<bool, 4> joined{};
    for (std::size_t i = 0; i < 4; ++i) {
      if (around[i] == ScanGrid::kNoReturn) continue;
      if (link(own, positions_[around[i]], grid_.sensor) == Link::kJump) return Vector3d::Zero();
      joined[i] = true;
    }
    Vector3d sum = Vector3d::Zero();
    int corners = 0;
    for (std::size_t i = 0; i < 4; ++i) {
      const std::size_t next = (i + 1) % 4;
      if (!joined[i] || !joined[next]) continue;
      sum += (positions_[around[i]] - own).cross(positions_[around[next]] - own);
      ++corners;
    }
    return corners < 2 ? Vector3d::Zero() : sum;
  }

  std::uint32_t point(std::size_t column, std::size_t row) const { return grid_.cells[row * grid_.columns + column]; }
  std::size_t rows() const { return rows_; }

 private:
  const std::vector<Vector3d>& positions_;
  const ScanGrid& grid_;
  std::size_t rows_;
};

/// Leaves out the points whose normal is zero.
void keep_oriented(Model& model) {
  std::size_t kept = 0;
  for (std::size_t i = 0; i < model.normals.size(); ++i) {
    if (model.normals[i].isZero(0.0)) continue;
    model.positions[kept] = model.positions[i];
    model.normals[kept] = model.normals[i];
    if (!model.lines.empty()) model.lines[kept] = model.lines[i];
    if (!model.stiffness.empty()) model.stiffness[kept] = model.stiffness[i];
    ++kept;
  }
  model.positions.resize(kept);
  model.normals.resize(kept);
  if (!model.lines.empty()) model.lines.resize(kept);
  if (!model.stiffness.empty()) model.stiffness.resize(kept);
}

}  // namespace

std::optional<std::size_t> orient_by_grid(Model& model, const ScanGrid& scan) {
  if (scan.columns < 2 || scan.cells.size() < 2 * scan.columns) return std::nullopt;
  const Grid grid(model.positions, scan);
  std::vector<Vector3d> normals(model.positions.size(), Vector3d::Zero());
  std::size_t returns = 0, oriented = 0, facing = 0;
  for (std::size_t row = 0; row < grid.rows(); ++row) {
    for (std::size_t column = 0; column < scan.columns; ++column) {
      const std::uint32_t point = grid.point(column, row);
      if (point == ScanGrid::kNoReturn) continue;
      ++returns;
      const Vector3d normal = grid.normal(column, row);
      const double length = normal.norm();
      if (!(length > 0.0) || !std::isfinite(length)) continue;
      ++oriented;
      normals[point] = normal / length;
      facing += normal.dot(scan.sensor - model.positions[point]) > 0.0 ? 1U : 0U;
    }
  }
  if (2 * oriented < returns || oriented == 0) return std::nullopt;
  if (2 * facing < oriented) {
    for (Vector3d& normal : normals) normal = -normal;
  }
  const std::size_t before = model.positions.size();
  model.normals = std::move(normals);
  keep_oriented(model);
  return before - model.positions.size();
}

}  // namespace isotouch::cloud
