#include "host/trace/place_sample.h"

#include <cmath>

#include "firmware/core/field_sampler.h"
#include "firmware/core/stiffness_at.h"
#include "host/to_double.h"

namespace isotouch::trace {

namespace {

// Voxels. Nearer to the band's end, much of a distance comes from numbers that were clamped to the band. On an exact ball a distance below this is off
// by at most 0.022 voxels and a gradient by 2.2°; up to the band it would be 1.9 voxels and 83°, 2026-11-28.
constexpr double kClampedLayer = 1.0;
constexpr double kFarthest = 8191;  // voxels from the grid's origin: see core::sample_field

}  // namespace

PlaceSample sample_place(const FieldView& field, const Eigen::Vector3d& place) {
  const Eigen::Vector3d index = (place - to_double(field.origin)) / to_double(field.edge);
  const Vec3<Voxel> at = to_fixed<Voxel>(index.cwiseMax(-kFarthest).cwiseMin(kFarthest));
  const core::FieldSample sample = core::sample_field(field, at);
  const double voxels = to_double(sample.distance);
  return {voxels * to_double(field.edge), to_double(sample.gradient), to_double(core::stiffness_at(at, field, field.stiffness)),
          std::abs(voxels) < to_double(field.band) - kClampedLayer};
}

}  // namespace isotouch::trace
