/// Gives concave creases the fillet that the grid can hold.
///
/// A crease sharper than a voxel, sampled, becomes a row of small pits and saddles along the crease: a hand that slides there at constant depth
/// is felt to catch, by 20 degrees of force. With the roof of the field rounded to a curvature of 0.6 a voxel the pits are gone, to
/// below a degree. Convex edges stay as they are: there the proxy does not rest.
#pragma once

#include <vector>

#include "host/encoding/apron.h"
#include "host/field/band_field.h"

namespace isotouch::encoding {

/// Sum of the second derivatives that a concave crease keeps, 1 / voxel. Measured at creases of 60, 90 and 120 degrees, each in four random
/// directions, 4 voxels deep, 0.3 m/s.
inline constexpr float kSharpestCrease = 0.6F;

/// Lowers the distance where it bends down more sharply than `sharpest`: towards the largest field below the given one that nowhere does, by
/// Jacobi steps on that obstacle problem, to within a tenth. Gaps narrower than 2 / sharpest voxels lose some of their width.
///
/// field     bricks sorted by cell
/// around    its `neighbours`
/// returns   the same bricks; only samples within the band, with all six neighbours within it, can change, and only downwards
/// fails     never
field::BandField round_creases(field::BandField field, const std::vector<Neighbours>& around, float sharpest = kSharpestCrease);

}  // namespace isotouch::encoding
