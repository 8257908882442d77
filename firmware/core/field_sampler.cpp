#include "firmware/core/field_sampler.h"

#include "firmware/core/spline_sampler.h"
#include "firmware/core/trilinear_sampler.h"

namespace isotouch::core {

void sample_field(const FieldView& field, const Vec3<Voxel>& point, FieldSample& sample) {
  if (field.interpolation == Interpolation::kTrilinear) {
    sample_trilinear(field, point, sample);
  } else {
    sample_spline(field, point, sample);
  }
}

}  // namespace isotouch::core
