/// How the force follows a surface that has moved by itself, under a hand that perhaps rests.
///
/// The spring between hand and proxy gives the target. What the hand feels is the target less a vector, the lag. A patch moves the target; the lag takes
/// up that step, so that the force stays as it was, and then gets shorter by at most kFollow a tick. What the hand itself does, it feels at once. So
///
///   - a surface that rises under a resting hand pushes it gently, one that sinks lets it go gently, whatever the patch was;
///   - a hand that is pushed away does not make the force grow faster: its way only ever shortens the spring;
///   - a surface that is gone leaves its force behind, which decays, and which a hand that goes along with it uses up as it would a spring;
///   - the force is never larger than the target or what was given before, and never begins to pull.
///
/// A surface that jumps is no speed either: in that tick the damper holds what it gave, unless the hand's own change of speed explains more. What it
/// gives afterwards may differ, because the surface faces another way, and the lag takes up that difference, too. Where a patch gives the contact to a
/// hand that moves, the dampers of the hand begin at zero, and come once the spring has followed.
///
/// Only the shrinking of the lag gives energy to the hand that the hand has not given.
#pragma once

#include <cstdint>

#include "shared/units.h"
#include "shared/vec3.h"

namespace isotouch::core {

/// Largest change of the force in a tick that is not the hand's doing, less than 0.05 N: 50 N/s at 1 kHz. The rest is for the small steps of a proxy that
/// has settled, which are felt as they are, and for rounding.
inline constexpr Newton kFollow = Newton::of(0.0475);
/// Ticks in which steps of the target go into the lag, after a patch and after every later tick in which the proxy still finds its place on the moved
/// surface: in creases it slides there for some ticks.
inline constexpr std::uint8_t kSettlingTicks = 16;

struct Lag {
  Vec3<Newton> felt;    ///< what the spring gave in the last tick
  Vec3<Newton> damper;  ///< what the spring's damper gave in it
  Newton withheld;      ///< what is missing of other dampers, because a patch gave the contact
  bool on = false;
  bool moved = false;         ///< since the last tick
  bool limited = false;       ///< the force limit was, in the last tick
  std::uint8_t settling = 0;  ///< ticks left
};

/// What the hand would feel without a lag.
struct LagInput {
  Vec3<Newton> target;   ///< stiffness times deflection; zero without contact
  Vec3<Newton> step;     ///< stiffness times the change of the deflection in this tick
  Vec3<Newton> by_hand;  ///< stiffness times the way of the HIP in this tick
  Vec3<Newton> damper;   ///< damping times the change of the deflection; zero without contact
  Vec3<Newton> gain;     ///< damping times what the way of the HIP is more than in the last tick
  Vec3<Newton> others;   ///< what other dampers give in contact
  Vec3<Newton>
      limited;  ///< what the force limit let through of `Lag::felt`; from there the force follows a surface that has moved or is gone
  bool touched = false;  ///< in the last tick
  bool touching = false;
  bool arriving = false;  ///< the proxy has not settled on the surface
};

/// A patch: the lag is on until the force has followed.
///
/// given     the spring's force in the last tick; counts only where the lag is off
/// tick      yes
void surface_moved(const Vec3<Newton>& given, Lag& lag);

/// The part of other dampers that counts.
///
/// tick      yes
Vec3<Newton> let_through(const Vec3<Newton>& others, const Lag& lag);

/// returns   the spring's force that is felt; a target beyond 4095 N a component counts as that. To it comes `lag.damper`
/// fails     never
/// tick      yes: constant cost, no division
Vec3<Newton> follow_target(const LagInput& in, Lag& lag);

}  // namespace isotouch::core
