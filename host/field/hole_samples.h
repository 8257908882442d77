/// Samples for small holes in a scan whose rim does not say how the surface goes on.
///
/// Where a scan ends, the local models go on as their samples say. That is right on a gentle surface. Round the rim of a hole that turns inward, as
/// a lip does, the models lead into the body. The winding number spans such a hole like a skin: it is one half there.
///
/// source    advancing front on a level set; the level set: winding_sign.h
#pragma once

#include "host/cloud/oriented_points.h"
#include "host/field/surface.h"

namespace isotouch::field {

/// Samples about as far apart as those of the scan, on the skin over each hole of at most a few hundred samples where the models disagree with it.
///
/// scan      the one that `surface` was made of
/// returns   positions, normals and, where the scan has it, stiffness; none for a closed scan
cloud::OrientedPoints hole_samples(const Scan& scan, const Surface& surface);

}  // namespace isotouch::field
