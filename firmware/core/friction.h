/// Friction at the proxy: the proxy that is felt sticks to the surface within Coulomb's cone and slides on its rim.
///
/// The geometric proxy is where the surface without friction would hold the hand. What is felt instead is that point and an offset in the tangent
/// plane towards where the surface was last gripped, so that tangential force is stiffness times offset and the cone is |offset| <= μ depth. While the
/// proxy sticks, the gripped point does not change, so it cannot drift.
///
/// source    Salisbury and others 1995, Haptic rendering: programming touch interaction with virtual objects; friction cone algorithm: Harwin and
///           Melder 2002; DESIGN.md, "Feel"
#pragma once

#include "firmware/core/coupling.h"
#include "firmware/core/proxy.h"
#include "shared/units.h"
#include "shared/vec3.h"

namespace isotouch::core {

struct Friction {
  Ratio coefficient;       ///< μ, Coulomb; 0 to 1.5
  DampingPerTick viscous;  ///< while sliding; up to 127 N/mm a tick

  bool is_on() const { return coefficient > Ratio{} || viscous > DampingPerTick{}; }
};

struct FrictionState {
  Vec3<Voxel> grip;  ///< the point of the surface that is gripped, index coordinates
  bool holds = false;
};

/// Moves the gripped point as far as the hand drags it.
///
/// Coulomb's part limits the offset to a fixed radius. The viscous part is solved implicitly, so that it damps at every rate: after sliding, the
/// offset e' satisfies
/// k e' = k μ depth + b (e - e'), so e' = (k μ depth + b e) / (k + b).
///
/// contact     proxy and deflection of the surface without friction, within ±8191 voxels
/// stiffness   of the surface there
/// returns     what is added to proxy and deflection, in the plane across the deflection; zero without contact, which forgets the grip
/// fails       never
/// tick        yes: constant cost, no division
Vec3<Voxel> friction_offset(const Contact& contact, Stiffness stiffness, const Friction& friction, FrictionState& state);

}  // namespace isotouch::core
