/// The place of a triangle nearest to a point.
#pragma once

#include <Eigen/Core>
#include <array>

namespace isotouch::field {

/// A place on a triangle, and what of the triangle it lies on: 0 to 2 a corner, 3 to 5 an edge (corner 0 to 1, 1 to 2, 2 to 0), 6 the inside.
struct OnTriangle {
  Eigen::Vector3d point;
  int feature;
};

using Corners = std::array<Eigen::Vector3d, 3>;

/// source    C. Ericson, Real-Time Collision Detection, 2005, section 5.1.5
inline OnTriangle nearest_on_triangle(const Eigen::Vector3d& p, const Corners& triangle) {
  const auto& [a, b, c] = triangle;
  const Eigen::Vector3d ab = b - a;
  const Eigen::Vector3d ac = c - a;
  const double d1 = ab.dot(p - a);
  const double d2 = ac.dot(p - a);
  if (d1 <= 0 && d2 <= 0) return {a, 0};
  const double d3 = ab.dot(p - b);
  const double d4 = ac.dot(p - b);
  if (d3 >= 0 && d4 <= d3) return {b, 1};
  const double d5 = ab.dot(p - c);
  const double d6 = ac.dot(p - c);
  if (d6 >= 0 && d5 <= d6) return {c, 2};
  const double vc = d1 * d4 - d3 * d2;
  if (vc <= 0 && d1 >= 0 && d3 <= 0) return {a + d1 / (d1 - d3) * ab, 3};
  const double va = d3 * d6 - d5 * d4;
  if (va <= 0 && d4 - d3 >= 0 && d5 - d6 >= 0) return {b + (d4 - d3) / ((d4 - d3) + (d5 - d6)) * (c - b), 4};
  const double vb = d5 * d2 - d1 * d6;
  if (vb <= 0 && d2 >= 0 && d6 <= 0) return {a + d2 / (d2 - d6) * ac, 5};
  const double scale = 1 / (va + vb + vc);
  return {a + vb * scale * ab + vc * scale * ac, 6};
}

}  // namespace isotouch::field
