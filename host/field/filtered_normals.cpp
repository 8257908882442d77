#include "host/field/filtered_normals.h"

#include <Eigen/Cholesky>
#include <cstddef>
#include <cstdint>

#include "host/field/parallel.h"

namespace isotouch::field {

namespace {

using Eigen::Vector3d;

// By trial of 2026-11 with normals tilted by 15 and 30 degrees on three objects.
constexpr std::size_t kPlane =
    7;  // samples of a plane, its own among them: with 9 a plate's rim is rounder, from truth to field 0.19 instead of 0.15
constexpr std::size_t kPlanes = 9;  // asked for a normal: with 7 an owl has 0.30 instead of 0.28 from field to truth
constexpr double kOffPlane = 0.14;  // of the distance to the sixth neighbour: so far do positions leave their plane, by curvature
constexpr double kLeastMisfit = 1e-3;

struct Plane {
  Vector3d normal, middle;
  double misfit = 0.0;  ///< of its samples in the mean, squared, in standard deviations
};

double squared(double x) { return x * x; }

Plane plane_at(const Scan& scan, std::size_t i, double normal_variance) {
  const auto around = scan.around(i, kPlane);
  const double position_variance = squared(kOffPlane * scan.spacing(i));
  const auto belongs = [&](const Neighbour& n) { return scan.normals()[n.index].dot(scan.normals()[i]) >= 0.0; };
  Plane plane{Vector3d::Zero(), Vector3d::Zero()};
  Vector3d sum = Vector3d::Zero();
  double count = 0.0;
  for (const Neighbour& n : around) {
    if (!belongs(n)) continue;
    plane.middle += scan.positions()[n.index];
    sum += scan.normals()[n.index];
    count += 1.0;
  }
  plane.middle /= count;
  if (!(position_variance > 0.0)) return {scan.normals()[i], plane.middle, 0.0};
  Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();
  for (const Neighbour& n : around) {
    if (!belongs(n)) continue;
    const Vector3d way = scan.positions()[n.index] - plane.middle;
    spread += way * way.transpose();
  }
  Eigen::Matrix3d system = spread / position_variance;
  system.diagonal().array() += count / normal_variance;
  plane.normal = Vector3d(system.ldlt().solve(sum)).normalized();
  plane.misfit = plane.normal.dot(spread * plane.normal) / position_variance;
  for (const Neighbour& n : around) {
    if (belongs(n)) plane.misfit += (scan.normals()[n.index] - plane.normal).squaredNorm() / normal_variance;
  }
  plane.misfit /= count;
  return plane;
}

Vector3d mean_of_planes(const Scan& scan, std::size_t i, const std::vector<Plane>& planes, double normal_variance) {
  const Vector3d &position = scan.positions()[i], &normal = scan.normals()[i];
  const double position_variance = squared(kOffPlane * scan.spacing(i));
  if (!(position_variance > 0.0)) return normal;
  Vector3d sum = Vector3d::Zero();
  for (const Neighbour& n : scan.around(i, kPlanes)) {
    const Plane& plane = planes[n.index];
    if (plane.normal.dot(normal) < 0.0) continue;
    const double height = plane.normal.dot(position - plane.middle);
    const double misfit = plane.misfit + height * height / position_variance + (normal - plane.normal).squaredNorm() / normal_variance;
    sum += plane.normal / squared(misfit + kLeastMisfit);
  }
  return sum.squaredNorm() > 0.0 ? Vector3d(sum.normalized()) : normal;
}

}  // namespace

std::vector<Vector3d> filtered_normals(const Scan& scan, double noise) {
  std::vector<Plane> planes(scan.size());
  in_parallel(scan.size(), 64, [&](std::size_t begin, std::size_t end) {
    for (const std::uint32_t i : scan.together(begin, end)) planes[i] = plane_at(scan, i, noise * noise);
  });
  std::vector<Vector3d> normals(scan.size());
  in_parallel(scan.size(), 64, [&](std::size_t begin, std::size_t end) {
    for (const std::uint32_t i : scan.together(begin, end)) normals[i] = mean_of_planes(scan, i, planes, noise * noise);
  });
  return normals;
}

}  // namespace isotouch::field
