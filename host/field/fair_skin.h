/// Bends a skin over a wide hole as the surface round it bends.
///
/// First the normals of the rim spread over the skin: each is the mean of its neighbours'. Then the positions follow: each sample moves along its
/// normal until, on average, it lies on the circles that its own and its neighbours' normals describe. A sphere and a cylinder are continued, and a
/// plane stays one.
///
/// source    normals first, positions after them: Tasdizen, Whitaker, Burchard, Osher, Geometric surface processing via normal maps, 2003
#pragma once

#include "host/cloud/oriented_points.h"
#include "host/field/scan.h"

namespace isotouch::field {

/// Lengths in the points' unit. Never fails; a sample without neighbours stays.
///
/// scan      whose rim the skin meets; its samples stay
/// skin      at least 1 sample, about as far apart as those of the scan; replaced positions and normals
void fair_skin(const Scan& scan, cloud::OrientedPoints& skin);

}  // namespace isotouch::field
