/// A field's distances at the nodes of its grid, as the core samples it: what a tool may show that knows nothing of splines.
#pragma once

#include "host/field/band_field.h"
#include "shared/field_view.h"

namespace isotouch::evaluate {

/// Every brick in which the spline comes within the band at a node, also where all coefficients are constant and only a neighbour's reach in. And
/// both bricks wherever the sign changes from one node to the next: a field may rise from within the band, or from far inside, to far outside in
/// one step, and a brick that is not listed has one sign, that of every node beside it.
///
/// returns   distances in voxels, with the core's own rounding; ±band beyond; `band` as the field has it
/// fails     InputError of `require_stored_surface`
field::BandField node_distances(const FieldView& field);

}  // namespace isotouch::evaluate
