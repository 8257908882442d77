/// Which part of a field's surface was invented: it closes the scan at places that nobody scanned.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "host/field/band_field.h"
#include "host/field/sound_scan.h"
#include "host/field/spacings.h"

namespace isotouch::field {

struct InventedSurface {
  std::vector<Eigen::Vector3i> cells;  ///< of the bricks whose surface was invented, in the field's order
  double share = 0;                    ///< of the surface
};

/// A brick is judged at its sample nearest to the surface, by the points that look to the same side. That was invented when an invented point is nearer to
/// it than every measured one, or when it lies in a gap: farther from every measured point than these are apart there.
///
/// sound     workspace, mm; what `field` was built from
/// spacings  of its points
InventedSurface invented_surface(const BandField& field, const SoundScan& sound, const Spacings& spacings);

}  // namespace isotouch::field
