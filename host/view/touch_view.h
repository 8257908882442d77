/// From where a touch is seen.
#pragma once

#include "host/view/camera.h"
#include "host/view/field_ray.h"
#include "host/view/markers.h"

namespace isotouch::view {

/// How badly an eye sees a touch: 0 where the surface under the proxy is turned 55 degrees from it, one more for each degree that it is not; above
/// 1000 where the object hides the proxy.
double view_cost(const Touch& touch, const Direction& direction, const FieldRays& rays);
/// The same where nothing hides the proxy: never more.
double slant_cost(const Touch& touch, const Direction& direction);

/// The direction that sees the touch well and is near the default one.
Direction direction_showing(const Touch& touch, const FieldRays& rays, char up);

}  // namespace isotouch::view
