/// Whether a field's surface lies in its stored bricks. A file of a thousand bytes can describe a grid of constant bricks that change sides everywhere, and
/// what is made of such a surface would fill the memory.
#pragma once

#include <Eigen/Core>

#include "shared/field_view.h"

namespace isotouch::evaluate {

/// Is the brick far inside throughout, and one that touches it with a face far outside throughout? Then the surface lies between the two.
///
/// cell      of the brick, within the root table
bool jumps_beside(const FieldView& field, const Eigen::Vector3i& cell);

/// fails     InputError when far more bricks jump than are stored: `build` leaves few that do
void require_stored_surface(const FieldView& field);

}  // namespace isotouch::evaluate
