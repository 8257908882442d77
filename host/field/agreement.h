/// Single normals that point the wrong way, turned round.
#pragma once

#include "host/field/scan.h"

namespace isotouch::field {

/// Turns the normal of a sample round when three quarters of the neighbours that lie beside it, on its own tangent plane and it on theirs, say the
/// opposite. On a thin plate, where the other side says so too, half of the neighbours agree and nothing is turned.
///
/// scan      most normals outward
/// returns   how many were turned; each was judged by the normals as they came
std::size_t turn_contradicted(Scan& scan);

}  // namespace isotouch::field
