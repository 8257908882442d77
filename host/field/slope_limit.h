/// A field that never claims more than it can hold.
///
/// Over a hole that nobody scanned the local models of its rims disagree, and where one hands over to the other, or to the enclosure, the distance
/// jumps from one side of the band to the other. The surface there is as good a guess as any, but distances beside a jump are larger than the
/// way to it. They are shortened until the field is a distance again.
#pragma once

#include "host/field/band_field.h"

namespace isotouch::field {

/// Shortens distances until two samples face to face differ by no more than `slope`. No sign changes, and a jump's middle stays where it is.
///
/// field     bricks sorted by cell; an unlisted one lies as far inside or outside as the band reaches, by the sign that the brick before it in its row of
///           x ends with. More are listed where the slope asks for it
/// slope     voxels a voxel, above 1
/// source    the largest function below the given one with a bounded slope: McShane, Extension of range of functions, 1934
void limit_slopes(BandField& field, double slope);

}  // namespace isotouch::field
