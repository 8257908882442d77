/// How far a place surely is from an object's surface, read from the field's numbers without the tick's samplers.
#pragma once

#include "firmware/guard/arm_geometry.h"
#include "shared/field_view.h"

namespace isotouch::guard {

/// Between samples a field is an average of the numbers around: it is nowhere below the least of them.
///
/// field     whose numbers are distances: not one of the published method
/// at        mm, workspace frame
/// returns   mm: the surface is no nearer; at most the band. Below 0: the place may be inside
/// tick      no: it runs beside the tick. It does not allocate
double clearance(const FieldView& field, const Point& at);

}  // namespace isotouch::guard
