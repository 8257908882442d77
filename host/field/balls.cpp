#include "host/field/balls.h"

#include <algorithm>
#include <limits>

#include "host/field/nearest.h"

namespace isotouch::field {

namespace {

constexpr double kInfinite = std::numeric_limits<double>::infinity();

double pair_radius(const Eigen::Vector3d& p, const Eigen::Vector3d& n, const Eigen::Vector3d& q) {
  const Eigen::Vector3d a = q - p;
  const double depth = -n.dot(a);
  return depth > 0.0 ? a.squaredNorm() / (2.0 * depth) : kInfinite;
}

double packing_radius_brute_force(const cloud::OrientedPoints& points, std::size_t i) {
  double radius = kInfinite;
  for (std::size_t j = 0; j < points.size(); ++j) {
    if (j != i) radius = std::min(radius, pair_radius(points.positions[i], points.normals[i], points.positions[j]));
  }
  return radius;
}

/// The size of the numbers that are rounded: coordinates and the box of the points.
double largest_extent(const cloud::OrientedPoints& points) {
  double extent = 0.0;
  for (const auto& p : points.positions) extent = std::max(extent, p.cwiseAbs().maxCoeff());
  return 2.0 * extent;
}

}  // namespace

std::vector<double> packing_radii_brute_force(const cloud::OrientedPoints& points) {
  std::vector<double> radii(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) radii[i] = packing_radius_brute_force(points, i);
  return radii;
}

std::vector<double> packing_radii(const cloud::OrientedPoints& points) {
  if (points.size() == 0) return {};
  const Nearest tree(points.positions);
  const double extent = largest_extent(points);
  std::vector<double> radii(points.size());
  std::vector<Neighbour> found;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const auto& p = points.positions[i];
    const auto& n = points.normals[i];
    // Every ball that passes through a sample and is larger than this one bends less than rounding over the whole object.
    double radius = 1e3 * extent;
    bool through_a_sample = false;
    const auto shrink_to = [&](std::uint32_t j) {
      const double r = j == i ? kInfinite : pair_radius(p, n, points.positions[j]);
      if (!(r < radius)) return false;
      radius = r;
      through_a_sample = true;
      return true;
    };
    do {
      tree.nearest(p - radius * n, 1, found);
    } while (shrink_to(found.front().index));
    // What lies on the ball to rounding is compared by the very expression that brute force compares.
    for (bool shrunk = true; shrunk;) {
      tree.within(p - radius * n, radius + 1e-12 * (extent + radius), found);
      shrunk = false;
      for (const auto& f : found) shrunk = shrink_to(f.index) || shrunk;
    }
    radii[i] = through_a_sample ? radius : packing_radius_brute_force(points, i);
  }
  return radii;
}

}  // namespace isotouch::field
