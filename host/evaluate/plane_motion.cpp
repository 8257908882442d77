#include "host/evaluate/plane_motion.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cstddef>

namespace isotouch::evaluate {

using Eigen::Vector3d;

PlaneMotion plane_motion(const std::vector<Vector3d>& positions) {
  Vector3d mean = Vector3d::Zero();
  for (const Vector3d& p : positions) mean += p / static_cast<double>(positions.size());
  Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();
  for (const Vector3d& p : positions) spread += (p - mean) * (p - mean).transpose();
  const Eigen::Matrix3d axes = Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(spread).eigenvectors();  // the least first
  constexpr std::size_t kWindow = 250;                                                                 // ticks on either side
  constexpr double kMaxStep = 1;                                                                       // mm a tick
  PlaneMotion motion;
  double sum = 0;
  std::size_t begin = 0, end = 0;
  for (std::size_t i = 0; i < positions.size(); ++i) {
    const Vector3d step = i == 0 ? Vector3d(Vector3d::Zero()) : Vector3d(positions[i] - positions[i - 1]);
    motion.ahead.push_back(std::clamp(step.dot(axes.col(2)), -kMaxStep, kMaxStep));
    motion.aside.push_back(std::clamp(step.dot(axes.col(1)), -kMaxStep, kMaxStep));
    for (; end < std::min(i + kWindow, positions.size()); ++end) sum += positions[end].dot(axes.col(0));
    for (; begin + kWindow < i; ++begin) sum -= positions[begin].dot(axes.col(0));
    const double slow = sum / static_cast<double>(end - begin);
    motion.depth.push_back(std::clamp(0.5 + slow - positions[i].dot(axes.col(0)), 0.1, 1.0));
  }
  return motion;
}

}  // namespace isotouch::evaluate
