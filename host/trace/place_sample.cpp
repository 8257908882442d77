#include "host/trace/place_sample.h"

#include <cmath>

#include "firmware/core/field_sampler.h"
#include "firmware/core/stiffness_at.h"
#include "host/to_double.h"

namespace isotouch::trace {

namespace {

constexpr double kFarthest = 8191;  // voxels from the grid's origin: see core::sample_field

}  // namespace

PlaceSample sample_place(const FieldView& field, const Eigen::Vector3d& place) {
  const Eigen::Vector3d index = (place - to_double(field.origin)) / to_double(field.edge);
  const Vec3<Voxel> at = to_fixed<Voxel>(index.cwiseMax(-kFarthest).cwiseMin(kFarthest));
  const core::FieldSample sample = core::sample_field(field, at);
  const double voxels = to_double(sample.distance);
  return {voxels * to_double(field.edge), to_double(sample.gradient), to_double(core::stiffness_at(at, field, field.stiffness)),
          !sample.outside_grid && std::abs(voxels) < to_double(field.band)};
}

}  // namespace isotouch::trace
