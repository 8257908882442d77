/// Single normals that point the wrong way, turned round.
#pragma once

#include "host/field/scan.h"

namespace isotouch::field {

/// Turns the normals round that their neighbours contradict.
///
/// Each sample is a small magnet along its normal, and its energy in the field of its neighbours is the vote: those beside it want to point as it does,
/// and those across a thin part, back to back, want to point against it. So no part is too thin, and edges and creases ask for nothing else.
/// One that would lose energy by turning is turned.
///
/// scan      most normals outward
/// returns   how many were turned; each was judged by the normals as they came
/// source    the energy of two dipoles: m·n/r³ - 3 (m·r)(n·r)/r⁵
std::size_t turn_outvoted(Scan& scan);

}  // namespace isotouch::field
