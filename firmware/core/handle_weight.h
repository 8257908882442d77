/// Gravity compensation: what the handle weighs is held up, so that a hand carries nothing. The one force that is there without contact, and only where
/// it is asked for.
///
/// The mechanism's weight is taken for the same everywhere: what arms and rods add changes by less than a tenth of it within 50 mm of the workspace's
/// middle, which is less than the device's own friction.
#pragma once

#include "shared/units.h"
#include "shared/vec3.h"

namespace isotouch::core {

/// force     on the hand, device axes, y up
/// tick      yes
inline Vec3<Newton> with_handle_held_up(const Vec3<Newton>& force, Newton weight) { return {force.x, force.y + weight, force.z}; }

}  // namespace isotouch::core
