/// Samples for holes in a scan.
///
/// Where a scan ends, the local models go on as their samples say. That is right on a gentle surface. Round the rim of a hole that turns inward, as
/// a lip does, the models lead into the body. The winding number spans such a hole like a skin: it is one half there. A wide hole in a surface that
/// looks one way gets a skin that is bent like the surface round it (fair_skin.h). A skin that would come within 1 (the points' unit) of the closing
/// box of `surface` is not bent: where the end of a part is missing, its shape is unknown.
///
/// source    advancing front on a level set; the level set: winding_sign.h
#pragma once

#include "host/cloud/oriented_points.h"
#include "host/field/surface.h"

namespace isotouch::field {

/// Samples about as far apart as those of the scan, on the skin over each wide hole of at most a thousand samples, and over each other one of at most
/// two hundred where the models disagree with it.
///
/// scan      the one that `surface` was made of
/// returns   positions, normals and, where the scan has it, stiffness; none for a closed scan
cloud::OrientedPoints hole_samples(const Scan& scan, const Surface& surface);

}  // namespace isotouch::field
