/// The virtual coupling between proxy and HIP: a spring, optional dampers, a force limit, and a ramp where contact did not begin at rest.
///
/// source    Colgate, Stanley and Brown 1995, Issues in the haptic display of tool use; DESIGN.md, "Coupling"
#pragma once

#include <cstdint>

#include "firmware/core/lag.h"
#include "firmware/core/proxy.h"
#include "shared/tick_io.h"
#include "shared/units.h"
#include "shared/vec3.h"

namespace isotouch::core {

/// Damping over one tick period: newton for a change of deflection of one millimetre a tick. Range ±127 N/mm.
using DampingPerTick = Fixed<Unit<-1, 1, 0, 0>, 24>;

/// The one conversion of a damping to the tick's rate; clamped to 127 N/mm.
///
/// rate      ticks a second
/// tick      yes
constexpr DampingPerTick per_tick(Damping damping, PerSecond rate) { return mul<DampingPerTick>(damping, rate); }

/// One part of the ramp. Range ±1.99.
using RampPart = Fixed<Unit<0, 0, 0, 0>, 30>;

/// Prepared constants, see `make_coupling`.
struct Coupling {
  MmPerVoxel edge;
  Stiffness stiffness;  ///< the largest, where the field has a table of it
  DampingPerTick damping;
  Newton force_limit;
  std::uint32_t ramp_ticks = 0;
  RampPart ramp_part;  ///< 1 / ramp_ticks
};

struct CouplingState {
  Vec3<Mm> last_deflection;
  Vec3<Mm> last_way;
  std::uint32_t ramp = 0;  ///< ticks of the ramp done; ramp_ticks = full force
  Lag lag;
};

struct Force {
  Vec3<Newton> newton;  ///< on the hand
  bool limited = false;
  bool ramping = false;
  // The parts of the force, for the energy balance.
  Vec3<Mm> deflection;        ///< of the spring; zero without contact
  Vec3<Newton> spring;        ///< stiffness times deflection, before limit and ramp
  Ratio kept = Ratio::of(1);  ///< the share of the force that the limit left
};

/// A coupling for any field. `for_field` adds what depends on the field: its voxel edge and, unless the settings name one, its stiffness.
///
/// rate      ticks a second
/// tick      no: divides
Coupling make_coupling(const TickSettings& settings, PerSecond rate);
/// A table of stiffness scales the settings' stiffness as it scales the field's.
///
/// prepared     by the function above
/// tick         yes
Coupling for_field(const Coupling& prepared, const FieldView& field);

/// Contact → force on the hand. Without contact the force is zero in the same tick; the ramp starts again where the proxy was held inside
/// or had not arrived.
///
/// way       of the HIP in this tick
/// stiffness of the surface at the proxy: `coupling.stiffness`, or as much of it as the field's table says there
/// damping   a force against the hand's speed, added in contact
/// fails     never: shortens to the limit and keeps the direction, exactly for springs below 8191 N and deflections below 2047 mm; larger ones saturate
/// tick      yes: constant cost, no division
Force couple(const Contact& contact, const Vec3<Mm>& way, Stiffness stiffness, const Coupling& coupling, CouplingState& state,
             const Vec3<Newton>& damping = {});

/// The surface has moved by itself: from now on the force follows it by `couple_lagging`, as long as the lag is on.
///
/// stiffness of the surface at the proxy in the last tick
/// tick      yes
void begin_lag(Stiffness stiffness, const Coupling& coupling, CouplingState& state);

/// `couple` while the force lags. Without contact the force that was given is released; the lag takes the place of the ramp.
///
/// way       of the HIP in this tick
/// arriving  the proxy has not settled yet
/// returns   deflection and spring are those that are felt
/// tick      yes: constant cost, no division
Force couple_lagging(const Contact& contact, const Vec3<Mm>& way, bool arriving, Stiffness stiffness, const Coupling& coupling,
                     CouplingState& state, const Vec3<Newton>& damping = {});

}  // namespace isotouch::core
