#include "host/evaluate/surface_error.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "host/angle.h"
#include "host/error.h"
#include "host/motion/felt_surface.h"

namespace isotouch::evaluate {

namespace {

constexpr int kStepsPerVoxel = 16;
constexpr int kHalvings = 14;  // of a step: the sampler's own resolution of 2^-16 voxel, and two more

/// Voxels along the normal, of the crossing nearest to the point.
std::optional<double> crossing(const motion::FeltSurface& surface, const Eigen::Vector3d& point, const Eigen::Vector3d& normal) {
  const auto outside = [&](double offset) { return surface.sample(point + offset * surface.voxel_mm() * normal).distance > 0; };
  const auto refine = [&](double inner, double outer) {
    for (int i = 0; i < kHalvings; ++i) {
      const double middle = (inner + outer) / 2;
      (outside(middle) ? outer : inner) = middle;
    }
    return (inner + outer) / 2;
  };
  constexpr double kStep = 1.0 / kStepsPerVoxel;
  bool above = outside(0);  // the state at the search's upper and lower end
  bool below = above;
  std::optional<double> found;
  for (int i = 0; i < kSearchVoxels * kStepsPerVoxel && !found; ++i) {
    const double reach = i * kStep;
    const bool next_above = outside(reach + kStep);
    const bool next_below = outside(-reach - kStep);
    if (!above && next_above) found = refine(reach, reach + kStep);
    if (below && !next_below) {
      const double lower = refine(-reach - kStep, -reach);
      if (!found || -lower < *found) found = lower;
    }
    above = next_above;
    below = next_below;
  }
  return found;
}

}  // namespace

SurfaceError crossings_near(const FieldView& field, const cloud::OrientedPoints& truth) {
  const motion::FeltSurface surface(field);
  std::vector<double> offsets;
  offsets.reserve(truth.size());
  SurfaceError error;
  double squares = 0;
  double angle_squares = 0;
  for (std::size_t i = 0; i < truth.size(); ++i) {
    const std::optional<double> offset = crossing(surface, truth.positions[i], truth.normals[i]);
    if (!offset) {
      ++error.lost;
      continue;
    }
    const Eigen::Vector3d gradient = surface.sample(truth.positions[i] + *offset * surface.voxel_mm() * truth.normals[i]).gradient;
    const double angle = gradient.isZero(0) ? 180 : angle_deg(gradient, truth.normals[i]);
    offsets.push_back(std::abs(*offset));
    squares += *offset * *offset;
    angle_squares += angle * angle;
  }
  if (offsets.empty()) return error;
  const auto count = static_cast<double>(offsets.size());
  error.points = offsets.size();
  error.rms_voxel = std::sqrt(squares / count);
  error.rms_mm = error.rms_voxel * surface.voxel_mm();
  error.normal_rms_deg = std::sqrt(angle_squares / count);
  std::sort(offsets.begin(), offsets.end());
  error.p99_voxel = offsets[(offsets.size() * 99 + 99) / 100 - 1];
  error.max_voxel = offsets.back();
  return error;
}

SurfaceError surface_error(const FieldView& field, const cloud::OrientedPoints& truth) {
  const SurfaceError error = crossings_near(field, truth);
  if (error.points == 0) {
    throw InputError("not one of " + std::to_string(truth.size()) +
                     " true points has the field's surface within 2 voxels: nothing was compared; is the field of this object?");
  }
  return error;
}

}  // namespace isotouch::evaluate
