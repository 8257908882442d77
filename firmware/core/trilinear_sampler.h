/// A field whose numbers are the distances at its samples (SPEC.md 2.1): the distance is trilinear between the eight samples around a point,
/// and so is the gradient, from the central differences at these samples.
///
/// Value and gradient are continuous across cells. The gradient is not that of the value; it is smoother, and the two meet where the field is.
#pragma once

#include "firmware/core/field_sampler.h"

namespace isotouch::core {

/// As `sample_field`. The second derivatives are those of the gradient; of the two mixed ones, which differ, the mean.
///
/// returns   error against the exact formula: distance below 2^-14 voxel, gradient and second derivatives below 2^-13
/// tick      yes: 32 distances, constant cost, no division
/// source    Sreeni K. G., Distance Field based Haptic Rendering of Scattered Oriented Points, section 3.4
void sample_trilinear(const FieldView& field, const Vec3<Voxel>& point, FieldSample& sample);

}  // namespace isotouch::core
