/// How much of a field's surface lies where no point was.
#pragma once

#include "host/field/band_field.h"
#include "host/field/spacings.h"

namespace isotouch::field {

/// Spacings, the distance to the sixth neighbour, from the nearest point: farther away a gap begins.
inline constexpr double kGap = 1.5;

/// Share of the surface that is farther from the nearest point that looks to the same side than so many times the distance from there to its sixth
/// neighbour, plus a voxel. One of sixteen samples beside the surface is asked.
///
/// spacings  of the points; workspace, mm
/// limit     how many times
double unseen_share(const BandField& field, const Spacings& spacings, double limit);

}  // namespace isotouch::field
