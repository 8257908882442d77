#include "host/evaluate/shape_trial.h"

#include <cmath>
#include <utility>

#include "host/cloud/random.h"
#include "host/field/make_grid.h"
#include "host/field/sample_distance.h"
#include "host/published/build.h"
#include "host/to_double.h"

namespace isotouch::evaluate {

namespace {

constexpr double kSphereRadius = 80;  // voxels
constexpr double kSlideDepth = 4;     // voxels: 5 % of the radius

cloud::OrientedPoints in_workspace(cloud::OrientedPoints points) {
  for (Eigen::Vector3d& position : points.positions) position *= kTrialVoxel;
  return points;
}

field_file::OpenField as_field(const field::BandField& field, const ShapeTrial& trial, Method method) {
  encoding::FieldInfo info;
  info.method = method;
  info.point_count = static_cast<std::uint32_t>(trial.points.size());
  info.placement.scale = kTrialVoxel;
  return field_file::open_field(encoding::write_image(field, info), trial.shape.name);
}

}  // namespace

ShapeTrial shape_trial(const std::string& name, std::uint64_t seed) {
  ShapeTrial trial{cloud::shape(name), {}, {}, {}};
  trial.points = in_workspace(cloud::sample_shape(trial.shape, trial.shape.default_points, seed));
  trial.truth = in_workspace(cloud::scatter_on_shape(trial.shape, kTrialTruths, seed + 1'000'000));
  trial.grid = field::make_grid(kTrialVoxel * trial.shape.low, kTrialVoxel * trial.shape.high, kTrialVoxel, kTrialBand + 4);
  cloud::Random random(seed + 2'000'000);
  for (double& at : trial.grid.origin) at = to_double(to_fixed<Mm>(at + kTrialVoxel * random.uniform(-0.5, 0.5)));
  return trial;
}

ShapeTrial damaged_trial(const ShapeTrial& trial, const Damage& damage, std::uint64_t seed) {
  ShapeTrial result = trial;
  result.points = damaged(trial.points, damage, seed + 3'000'000);
  const double side = kTrialVoxel * (trial.shape.high - trial.shape.low).maxCoeff();
  const int wider = static_cast<int>(std::ceil(kStrayMargin * side / trial.grid.edge));
  result.grid.size.array() += 2 * wider;
  result.grid.origin.array() -= wider * trial.grid.edge;
  return result;
}

field_file::OpenField trial_field(const ShapeTrial& trial, Method method, field::Repair* repair) {
  field::Progress progress;
  if (method == Method::kPublished) {
    return as_field(published::to_band_field(published::build(trial.points, trial.grid, progress).levels), trial, method);
  }
  return as_field(field::build_field(trial.points, trial.grid, kTrialBand, progress, repair), trial, method);
}

field_file::OpenField floor_field(const ShapeTrial& trial) {
  const auto distance = [&](const Eigen::Vector3d& point) { return trial.distance(point); };
  return as_field(field::sample_distance(distance, trial.grid, kTrialBand), trial, Method::kDefault);
}

SphereSlide trial_slide(const FieldView& field, double speed) {
  SphereSlide slide;
  slide.radius = kSphereRadius * kTrialVoxel;
  slide.depth = kSlideDepth * kTrialVoxel;
  slide.speed = speed;
  slide.stiffness = to_double(field.stiffness);
  return slide;
}

}  // namespace isotouch::evaluate
