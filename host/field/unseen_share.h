/// How much of a field's surface lies where no point was.
#pragma once

#include <cstdint>

#include "host/field/band_field.h"
#include "host/field/spacings.h"

namespace isotouch::field {

/// Spacings, the distance to the sixth neighbour, from the nearest point: farther away a gap begins.
inline constexpr double kGap = 1.5;

/// Which points show a place.
enum class Showing : std::uint8_t {
  kAny,       ///< all of them; what the sign alone draws, such as in a shadow of the only view, is no surface then
  kSameSide,  ///< those that look to the same side as the surface there: the other side of a wall shows nothing of this one
};

/// Share of the surface that is farther from the nearest point that shows it than so many times the distance from there to its sixth neighbour, plus a
/// voxel. One of sixteen samples beside the surface is asked.
///
/// spacings  of the points; workspace, mm
/// limit     how many times
double unseen_share(const BandField& field, const Spacings& spacings, double limit, Showing showing = Showing::kSameSide);

}  // namespace isotouch::field
