/// What a hand should feel of a sphere round the origin, tick by tick of a recording.
#pragma once

#include <algorithm>

#include "host/to_double.h"
#include "shared/tick_io.h"

namespace isotouch::evaluate {

/// kind        of the recording's inputs
/// out         recorded
/// radius      mm
/// stiffness   N/mm
/// limit       N
/// returns     N; none for a hand that began inside, or while a device gives no force
inline double exact_sphere_force(InputKind kind, const Output& out, double radius, double stiffness, double limit) {
  if (!may_give_force(kind, out) || (out.status & kHeldInside) != 0) return 0;
  return std::min(stiffness * std::max(0.0, radius - to_double(out.hip).norm()), limit);
}

}  // namespace isotouch::evaluate
