/// Passivity observer and controller: a ledger of the energy that sampling and delay feed into the hand, and the damping that takes it back.
///
/// A wall that is held for a tick and felt d ticks late gives back more than was put into it: on the way in the force is that of less depth, on the way
/// out that of more. The observer books, tick by tick,
///
///     balance += b/T |Δx|² - F·Δx - ΔV
///
/// with Δx what the hand moved, F the force that it felt on this way, V what the spring holds and could give back, and b the device's own damping. As
/// long as the stiffness is within the certificate's 2b/((2d+1)T), the sum of these is never negative, whatever the counts do. Beyond it, it is, and the
/// controller adds damping in proportion to what is missing:
///
///   - no more than a set coefficient, because damping from a late, filtered velocity is itself unstable where it is large;
///   - along a continuous line, not the whole debt in one tick (Hannaford and Ryu's alpha = E / (T v²)): that is what makes noise of counts;
///   - on a velocity with a play of one count, `hand_damping.h`: none on a hand that rests;
///   - only half of what it takes is booked as paid: with delay it acts after the fact, and a loop that is just passive goes on swinging.
///
/// A surplus is kept only up to kMaxSurplus: what the hand lost long ago may not be spent now. The ledger is one of a contact: it begins anew where
/// the force is not wholly the surface's (ramps), and a debt that a contact leaves is taken into the next.
///
/// source    Hannaford and Ryu 2002, Time-domain passivity control of haptic interfaces; stored energy as reference: Ryu and others 2005; certificate:
///           Colgate and Schenkel 1997
#pragma once

#include <array>
#include <cstdint>

#include "firmware/core/coupling.h"
#include "shared/units.h"
#include "shared/vec3.h"

namespace isotouch::core {

/// Energy, N·mm, which are mJ: range ±2047, resolution 1 nJ.
using Energy = Fixed<Unit<1, 1, 0, 0>, 20>;

/// Largest surplus that is kept.
inline constexpr Energy kMaxSurplus = Energy::of(0.02);
/// Debt from which on all the damping allowed is injected. By trial with 0.3 kg at twice the certificate's stiffness and 1 to 3 ticks of delay: a
/// quarter of it doubles the noise of counts, four times it lets 1.5 mJ through.
inline constexpr Energy kFullDebt = Energy::of(0.2);

struct Passivity {
  Damping most;             ///< that may be injected; 0 = off
  DampingPerTick device;    ///< b/T
  std::uint32_t delay = 0;  ///< d, 0 to 7

  bool is_on() const { return most > Damping{}; }
};

struct PassivityState {
  static constexpr std::uint32_t kForces = 8;  // a power of two
  Energy balance;
  Energy stored;                               ///< in the spring
  std::array<Vec3<Newton>, kForces> forces{};  ///< commanded in the last ticks, with half of the injected part
  std::uint8_t tick = 0;                       ///< of the forces that are known: counts to 15, then again from 8
  bool begun = false;
};

/// The energy balance starts again with the next tick: without debt, and without a force that is still felt.
void forget(PassivityState& state);

/// returns   the damping to inject now: 0 without debt, at most `most`
/// tick      yes
Damping injected_damping(const Passivity& passivity, const PassivityState& state);

/// Adds one tick to the energy balance.
///
/// way       of the HIP since the tick before; more than 16 mm count as 16
/// force     the force that is commanded, with the spring that it comes from. A ramping force restarts the balance
/// injected  the part of it that this controller added
/// tick      yes: constant cost, no division
void book_energy(const Vec3<Mm>& way, const Force& force, const Vec3<Newton>& injected, const Passivity& passivity, PassivityState& state);

}  // namespace isotouch::core
