#include "host/field/filtered_normals.h"

#include <Eigen/Cholesky>
#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>

#include "host/field/parallel.h"
#include "host/field/patch_fit.h"

namespace isotouch::field {

namespace {

using Eigen::Vector3d;

// By trial of 2026-11 with normals tilted by 15 and 30 degrees on three objects.
constexpr std::size_t kPlane =
    7;  // samples of a plane, its own among them: with 9 a plate's rim is rounder, from truth to field 0.19 instead of 0.15
constexpr std::size_t kPatches = 9;  // asked for a normal: with 7 an owl has 0.30 instead of 0.28 from field to truth
constexpr double kOffPlane = 0.14;   // of the distance to the sixth neighbour: so far do positions leave their plane, by curvature
constexpr double kLeastMisfit = 1e-3;
constexpr std::size_t kPatch = 12;         // samples of a patch, its own among them; with 10 bars have 0.3 % more volume
constexpr std::size_t kFewestOfPatch = 5;  // six parameters, three equations a sample
constexpr std::size_t kSteps = 3;          // with 6 nothing changes
constexpr double kFarSide = -0.3;          // cosine to the plane's normal: round a rod a patch sees farther than a plane
constexpr double kFreedomOfPlane = 1.0 - 3.0 / (3.0 * kPlane);

/// What the samples round one of them describe.
struct Patch {
  ToroidalPatch surface;
  double misfit;  ///< of its samples in the mean, squared, in standard deviations
};

/// Without curvature.
ToroidalPatch flat(const Vector3d& point, const Vector3d& normal) {
  const Vector3d across = normal.unitOrthogonal();
  return {point, normal, across, normal.cross(across), 0.0, 0.0};
}

double squared(double x) { return x * x; }

Patch plane_at(const Scan& scan, std::size_t i, double normal_variance) {
  const auto around = scan.around(i, kPlane);
  const double position_variance = squared(kOffPlane * scan.spacing(i));
  const auto belongs = [&](const Neighbour& n) { return scan.normals()[n.index].dot(scan.normals()[i]) >= 0.0; };
  Vector3d middle = Vector3d::Zero(), sum = Vector3d::Zero();
  double count = 0.0;
  for (const Neighbour& n : around) {
    if (!belongs(n)) continue;
    middle += scan.positions()[n.index];
    sum += scan.normals()[n.index];
    count += 1.0;
  }
  middle /= count;
  if (!(position_variance > 0.0)) return {flat(middle, scan.normals()[i]), 0.0};
  Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();
  for (const Neighbour& n : around) {
    if (!belongs(n)) continue;
    const Vector3d way = scan.positions()[n.index] - middle;
    spread += way * way.transpose();
  }
  Eigen::Matrix3d system = spread / position_variance;
  system.diagonal().array() += count / normal_variance;
  const Vector3d normal = Vector3d(system.ldlt().solve(sum)).normalized();
  double misfit = normal.dot(spread * normal) / position_variance;
  for (const Neighbour& n : around) {
    if (belongs(n)) misfit += (scan.normals()[n.index] - normal).squaredNorm() / normal_variance;
  }
  return {flat(middle, normal), misfit / count};
}

/// Squared, in standard deviations.
double misfit_of(const ToroidalPatch::Value& there, const Vector3d& normal, const Variances& variances) {
  return squared(there.distance) / variances.position + (normal - there.gradient).squaredNorm() / variances.normal;
}

/// The plane, or the patch that Gauss-Newton steps from the plane at the sample lead to, if that explains its samples better for its parameters:
/// generalised cross-validation.
Patch plane_or_round(const Scan& scan, std::size_t i, double normal_variance) {
  const Patch plane = plane_at(scan, i, normal_variance);
  const Vector3d& normal = plane.surface.normal;
  const Variances variances{squared(kOffPlane * scan.spacing(i)), normal_variance};
  std::array<WeightedSample, kPatch> members;
  std::size_t count = 0;
  double reach = 0.0;
  for (const Neighbour& n : scan.around(i, kPatch)) {
    if (scan.normals()[n.index].dot(normal) < kFarSide) continue;
    members[count++] = {scan.positions()[n.index], scan.normals()[n.index], 1.0};
    reach = std::max(reach, n.squared_distance);
  }
  if (count < kFewestOfPatch || !(variances.position > 0.0) || !(reach > 0.0)) return plane;
  const auto used = std::span(members).first(count);
  const auto samples = static_cast<double>(count);
  const double price = squared(kFreedomOfPlane / (1.0 - 6.0 / (3.0 * samples))) / samples;
  Patch best = plane;
  ToroidalPatch patch = flat(scan.positions()[i], normal);
  for (std::size_t step = 0; step < kSteps; ++step) {
    patch = nearer_patch(patch, used, variances, std::sqrt(reach));
    double misfit = 0.0;
    for (const WeightedSample& m : used) misfit += misfit_of(patch.value(m.position), m.normal, variances);
    if (price * misfit < best.misfit) best = {patch, price * misfit};
  }
  return best;
}

Vector3d mean_of_patches(const Scan& scan, std::size_t i, const std::vector<Patch>& patches, double normal_variance) {
  const Vector3d &position = scan.positions()[i], &normal = scan.normals()[i];
  const double position_variance = squared(kOffPlane * scan.spacing(i));
  if (!(position_variance > 0.0)) return normal;
  Vector3d sum = Vector3d::Zero();
  for (const Neighbour& n : scan.around(i, kPatches)) {
    const Patch& patch = patches[n.index];
    const ToroidalPatch::Value there = patch.surface.value(position);
    if (there.gradient.dot(normal) < 0.0) continue;
    const double misfit = patch.misfit + misfit_of(there, normal, {position_variance, normal_variance});
    sum += there.gradient / squared(misfit + kLeastMisfit);
  }
  return sum.squaredNorm() > 0.0 ? Vector3d(sum.normalized()) : normal;
}

}  // namespace

std::vector<Vector3d> filtered_normals(const Scan& scan, double noise) {
  std::vector<Patch> patches(scan.size());
  in_parallel(scan.size(), 64, [&](std::size_t begin, std::size_t end) {
    for (const std::uint32_t i : scan.together(begin, end)) patches[i] = plane_or_round(scan, i, noise * noise);
  });
  std::vector<Vector3d> normals(scan.size());
  in_parallel(scan.size(), 64, [&](std::size_t begin, std::size_t end) {
    for (const std::uint32_t i : scan.together(begin, end)) normals[i] = mean_of_patches(scan, i, patches, noise * noise);
  });
  return normals;
}

}  // namespace isotouch::field
