/// A field's distances at the nodes of its grid, as the core samples it: what a tool may show that knows nothing of splines.
#pragma once

#include "host/field/band_field.h"
#include "shared/field_view.h"

namespace isotouch::evaluate {

/// Every brick in which the spline comes within the band at a node, also where all coefficients are constant and only a neighbour's reach in.
///
/// returns   distances in voxels, with the core's own rounding; ±band beyond; `band` as the field has it
/// fails     never
field::BandField node_distances(const FieldView& field);

}  // namespace isotouch::evaluate
