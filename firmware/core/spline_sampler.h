/// A field whose numbers are the coefficients of a quadratic B-spline (SPEC.md 2.1): value, gradient and second derivatives at a point.
///
/// All three come from one function, so they are consistent; value and gradient are continuous across cells.
#pragma once

#include "firmware/core/field_sampler.h"

namespace isotouch::core {

/// As `sample_field`.
///
/// returns   error against the exact spline: distance below 2^-14 voxel, gradient below 2^-13
/// tick      yes: 27 coefficients, constant cost, no division
/// source    quadratic B-spline: de Boor, A Practical Guide to Splines, 1978, chapter IX
void sample_spline(const FieldView& field, const Vec3<Voxel>& point, FieldSample& sample);

}  // namespace isotouch::core
