/// The proxy (god-object): the point that follows the HIP and never passes the surface.
///
/// It searches near its last place for the point on or outside the surface that is closest to the HIP: min |p - h|² subject to φ(p) >= 0, by a fixed number
/// of steps of sequential quadratic programming on the sampled field, one sample each. The same steps carry it through free space.
///
/// source    god-object: Zilles and Salisbury 1995; virtual proxy: Ruspini, Kolarov and Khatib 1997; Newton step on the Lagrangian: Nocedal and
///           Wright, Numerical Optimization, 2nd ed., section 18.1; DESIGN.md, "Proxy"
#pragma once

#include <cstdint>

#include "firmware/core/field_sampler.h"
#include "firmware/core/surface_step.h"
#include "shared/field_view.h"
#include "shared/units.h"
#include "shared/vec3.h"

namespace isotouch::core {

/// Steps a tick; each samples the field once.
inline constexpr int kProxySteps = 3;

enum class ProxyMode : std::uint8_t {
  kUnplaced,    ///< before the first tick
  kHeldInside,  ///< the HIP began inside the object and has not left it: no surface to hold yet
  kFree,        ///< in free space, at the HIP or on its way to it
  kContact,     ///< held by the surface
};

struct ProxyState {
  ProxyMode mode = ProxyMode::kUnplaced;
  Vec3<Voxel> point;   ///< where the field was sampled last, index coordinates
  FieldSample sample;  ///< the field there
  Vec3<Voxel> proxy;   ///< the last proxy in contact
  Vec3<Voxel> hip;     ///< the last HIP
  StepMemory steps;
  bool unsettled = false;  ///< in contact, but the steps have not come to the surface: the next tick goes on from `proxy`
};

struct Contact {
  Vec3<Voxel> proxy;          ///< index coordinates; on the surface in contact, at the HIP in free space once arrived
  Vec3<Voxel> deflection;     ///< proxy - HIP where there is contact, else zero
  bool touching = false;      ///< held by the surface
  bool following = false;     ///< on the way to the HIP, not arrived: no force
  bool held_inside = false;   ///< the HIP began inside the object
  bool outside_grid = false;  ///< the HIP is outside the sampled box
};

/// Begins, or goes on, without a surface to hold: the proxy is the HIP, and contact is possible once the HIP is outside.
///
/// tick      yes
Contact rest_at(const Vec3<Voxel>& hip, const FieldView& field, ProxyState& state);

/// Moves the proxy towards the HIP without passing the surface.
///
/// hip       index coordinates, within ±8191 voxels
/// field     the same view in every tick of a state's life
/// returns   contact; φ(proxy) >= -0.05 voxel in contact, as sampled; in a trilinear field, -0.13. A proxy in contact that comes to no surface in this
///           tick stays where it is, and the next tick goes on from there: it moves by less than 6 voxels a tick, by measurement
/// fails     never; a HIP that begins inside the object gives no contact until it has left
/// tick      yes: kProxySteps samples, constant cost, no division
Contact step_proxy(const Vec3<Voxel>& hip, const FieldView& field, ProxyState& state);

}  // namespace isotouch::core
