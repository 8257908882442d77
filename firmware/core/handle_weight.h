/// Gravity compensation: the motors hold up the weight of the handle. It is the only force without contact, and it is off unless it is set.
///
/// The same weight is used everywhere. What arms and rods add to it changes by less than a tenth within 50 mm of the workspace's middle, which is less
/// than the device's own friction.
#pragma once

#include "shared/units.h"
#include "shared/vec3.h"

namespace isotouch::core {

/// force     on the hand, device axes, y up
/// tick      yes
inline Vec3<Newton> with_handle_held_up(const Vec3<Newton>& force, Newton weight) { return {force.x, force.y + weight, force.z}; }

}  // namespace isotouch::core
