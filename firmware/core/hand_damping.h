/// Damping of the hand while it touches: a force against its filtered speed.
///
/// A velocity of single counts would be felt as buzz: one count of 40 µm in a millisecond is 40 mm/s. So the HIP drags the point that is differenced
/// through a play of one count: a hand at rest whose counts flicker between two values has no speed at all, and one that moves has its own.
///
/// source    Colgate and Brown 1994, Factors affecting the Z-width of a haptic display; play against quantisation: DESIGN.md, "Feel"
#pragma once

#include "firmware/core/hip_velocity.h"
#include "shared/units.h"
#include "shared/vec3.h"

namespace isotouch::core {

/// The largest count of either published set within 50 mm of the workspace's middle.
inline constexpr Mm kPlay = Mm::of(0.046);

struct QuietVelocityState {
  Vec3<Mm> dragged;
  VelocityState velocity;
};

/// The point dragged by the HIP, at most a play away on each axis.
inline Vec3<Mm> drag(const Vec3<Mm>& hip, const Vec3<Mm>& dragged) {
  const auto axis = [](Mm to, Mm from) { return to + within(from - to, kPlay); };
  return {axis(hip.x, dragged.x), axis(hip.y, dragged.y), axis(hip.z, dragged.z)};
}

/// hip, fresh, rate   as `hip_velocity`
/// returns   the velocity; dies to zero while the HIP stays within a play
/// tick      yes
inline Vec3<MmPerS> quiet_velocity(const Vec3<Mm>& hip, bool fresh, PerSecond rate, QuietVelocityState& state) {
  state.dragged = state.velocity.has_last ? drag(hip, state.dragged) : hip;
  return hip_velocity(state.dragged, fresh, rate, state.velocity);
}

/// returns   the force on the hand, against its velocity
/// tick      yes
inline Vec3<Newton> damping_force(const Vec3<MmPerS>& velocity, Damping damping) { return -mul<Newton>(velocity, damping); }

}  // namespace isotouch::core
