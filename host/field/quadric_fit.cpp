#include "host/field/quadric_fit.h"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

namespace isotouch::field {

namespace {

using Eigen::Vector3d;
using Form = Eigen::Matrix<double, 6, 1>;  // of 1, u, v, u², uv, v²

constexpr std::size_t kFewest = 8;  // positions, for six numbers

}  // namespace

QuadricFit fit_quadric(const std::vector<Vector3d>& positions, std::span<const Neighbour> neighbours) {
  const Vector3d& own = positions[neighbours[0].index];
  Vector3d middle = Vector3d::Zero();
  for (const Neighbour& n : neighbours) middle += positions[n.index];
  middle /= static_cast<double>(neighbours.size());
  Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();
  for (const Neighbour& n : neighbours) spread += (positions[n.index] - middle) * (positions[n.index] - middle).transpose();
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver;
  solver.compute(spread);  // square roots alone: the same on every machine
  const Vector3d normal = solver.eigenvectors().col(0), u = solver.eigenvectors().col(1), v = solver.eigenvectors().col(2);
  if (neighbours.size() < kFewest) return {normal.normalized(), normal.dot(middle - own), 0.0};

  const double reach = std::sqrt(neighbours.back().squared_distance);
  if (!(reach > 0.0)) return {normal.normalized(), 0.0, 0.0};
  Eigen::Matrix<double, 6, 6> products = Eigen::Matrix<double, 6, 6>::Zero();
  Form right = Form::Zero();
  const auto row = [&](const Vector3d& step) {
    const double x = u.dot(step) / reach, y = v.dot(step) / reach;
    return (Form() << 1, x, y, x * x, x * y, y * y).finished();
  };
  for (const Neighbour& n : neighbours) {
    const Vector3d step = positions[n.index] - own;
    const Form terms = row(step);
    for (Eigen::Index i = 0; i < 6; ++i) {
      for (Eigen::Index k = 0; k <= i; ++k) products(i, k) += terms[i] * terms[k];  // the lower half is all that the solver reads
    }
    right += terms * normal.dot(step);
  }
  products.diagonal().array() += 1e-9 * products.trace();
  const Form form = products.ldlt().solve(right);
  double squares = 0.0;
  for (const Neighbour& n : neighbours) {
    const Vector3d step = positions[n.index] - own;
    const double off = normal.dot(step) - form.dot(row(step));
    squares += off * off;
  }
  const Vector3d slope = normal - (form[1] / reach) * u - (form[2] / reach) * v;
  const double stretch = slope.norm();
  return {slope / stretch, form[0] / stretch, std::sqrt(squares / static_cast<double>(neighbours.size() - 6))};
}

}  // namespace isotouch::field
