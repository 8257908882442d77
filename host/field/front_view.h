/// A scan of one side as a picture: what its points look like from the sensor, from far away.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <algorithm>
#include <cstddef>
#include <limits>
#include <vector>

namespace isotouch::field {

/// Places across the line of sight have two coordinates and lie in square cells; heights go along it, to the sensor.
class FrontView {
 public:
  /// points    at least 1, of any length unit
  /// front     unit, to the sensor
  /// cell      side of a cell, their unit; larger where the picture would have more than 2048 along a side
  /// margin    empty cells all round
  FrontView(const std::vector<Eigen::Vector3d>& points, const Eigen::Vector3d& front, double cell, int margin)
      : front_(front), u_(front.unitOrthogonal()), v_(front.cross(u_)) {
    low_ = Eigen::Vector2d::Constant(std::numeric_limits<double>::infinity());
    Eigen::Vector2d high = -low_;
    for (const Eigen::Vector3d& p : points) {
      low_ = low_.cwiseMin(flat(p));
      high = high.cwiseMax(flat(p));
    }
    cell_ = std::max(cell, (high - low_).maxCoeff() / kMaxCells);
    low_.array() -= margin * cell_;
    const Eigen::Vector2d cells = ((high - low_) / cell_).array().floor();
    size_ = cells.cast<int>() + Eigen::Vector2i::Constant(margin + 1);
  }

  Eigen::Vector2d flat(const Eigen::Vector3d& p) const { return {u_.dot(p), v_.dot(p)}; }
  double height(const Eigen::Vector3d& p) const { return front_.dot(p); }
  Eigen::Vector3d solid(const Eigen::Vector2d& q, double height) const { return q.x() * u_ + q.y() * v_ + height * front_; }
  Eigen::Vector2i cell_of(const Eigen::Vector3d& p) const { return ((flat(p) - low_) / cell_).array().floor().cast<int>(); }
  /// Of a cell in a list of all of them, row by row.
  std::size_t index(const Eigen::Vector2i& cell) const {
    return static_cast<std::size_t>(cell.y()) * static_cast<std::size_t>(size_.x()) + static_cast<std::size_t>(cell.x());
  }
  Eigen::Vector2d middle(int x, int y) const { return low_ + cell_ * Eigen::Vector2d(x + 0.5, y + 0.5); }
  double cell() const { return cell_; }
  const Eigen::Vector2i& size() const { return size_; }

 private:
  static constexpr int kMaxCells = 2048;
  Eigen::Vector3d front_, u_, v_;
  Eigen::Vector2d low_;
  Eigen::Vector2i size_;
  double cell_ = 0;
};

}  // namespace isotouch::field
