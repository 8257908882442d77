/// One step of the proxy, from one sample of the field: the mathematics of `step_proxy`, without its loop.
///
/// Index coordinates throughout. tick: yes, every function: constant cost, no division, no failure.
#pragma once

#include "firmware/core/field_sampler.h"
#include "shared/units.h"
#include "shared/vec3.h"

namespace isotouch::core {

/// Where the surface lies from a sampled point, to first order.
struct SurfaceProjection {
  Vec3<Voxel> step;         ///< from the point straight onto the surface, -φ g / |g|²: one Newton step
  bool hip_behind = false;  ///< the HIP is behind the plane that the sample predicts for the surface, φ + g·(hip - point) < 0
};

/// These functions write their result into an argument: a small structure that is returned in registers would be packed through memory first.
void project_on_surface(const Vec3<Voxel>& hip, const Vec3<Voxel>& point, const FieldSample& sample, SurfaceProjection& projection);

/// What one step remembers of the one before. It damps the cycles in which Newton's step alone would stay in a rough crease.
struct StepMemory {
  Vec3<Voxel> last;                      ///< the last step, without its part straight onto the surface
  Voxel trust_radius = Voxel::of(1.25);  ///< how far beyond the free way a step is trusted
  Voxel ceiling = Voxel::of(1.25);       ///< the largest trust radius
};

/// Lets the steps reach twice as far as the hand has moved: `motion` is the HIP's since the last tick.
void renew_trust_radius(const Vec3<Voxel>& motion, StepMemory& memory);

/// After a tick whose steps have not come to the surface: the next ones are half as long.
void lower_trust(StepMemory& memory);
/// After one whose steps have: the next ones may be twice as long.
void raise_trust(StepMemory& memory);

/// Moves `point`, where the sample was taken, one step towards the point of the surface, or of free space, closest to the HIP.
///
/// In free space: to the HIP. Where the HIP is behind the surface: onto the surface and along it, by one step of sequential quadratic programming
/// with the field's second derivatives. Never longer than is safe, the surely free way to the surface and 1.25 voxels more; the part along the surface
/// gets shorter the deeper the point is inside, so that steps in an acute crease cannot add up to a passage, and it is halved where it turns back.
///
/// inverse_slope     how much of a distance outside is surely free way, FieldView::inverse_slope
void step_towards(const Vec3<Voxel>& hip, const FieldSample& sample, Ratio inverse_slope, StepMemory& memory, Vec3<Voxel>& point);

}  // namespace isotouch::core
