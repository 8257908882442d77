/// Small bodies with exact distances, on grids of one voxel a millimetre.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <functional>

#include "host/field/make_grid.h"
#include "host/field/sample_distance.h"

namespace isotouch::test {

using Distance3 = std::function<double(const Eigen::Vector3d&)>;

inline Distance3 ball(double radius) {
  return [=](const Eigen::Vector3d& p) { return p.norm() - radius; };
}

/// A ball with a round cavity in its middle.
inline Distance3 hollow_ball(double radius, double cavity) {
  return [=](const Eigen::Vector3d& p) { return std::max(p.norm() - radius, cavity - p.norm()); };
}

inline Distance3 box(const Eigen::Vector3d& half) {
  return [=](const Eigen::Vector3d& p) {
    const Eigen::Vector3d beyond = p.cwiseAbs() - half;
    return beyond.cwiseMax(0.0).norm() + std::min(beyond.maxCoeff(), 0.0);
  };
}

/// The body's field with its centre `shift` off the grid's own.
inline field::BandField field_of(const Distance3& distance, const Eigen::Vector3d& half, double band = 4.0,
                                 const Eigen::Vector3d& shift = {0.31, -0.17, 0.44}) {
  const field::Grid grid = field::make_grid(-half, half, 1.0, band + 4);
  return field::sample_distance([&](const Eigen::Vector3d& p) { return distance(p - shift); }, grid, band);
}

}  // namespace isotouch::test
