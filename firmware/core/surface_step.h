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
  Voxel trust_radius = Voxel::of(1.25);  ///< how far beyond the free way a step is trusted: 0 to ceiling
  Voxel ceiling = Voxel::of(1.25);       ///< the largest trust radius: 0 to 1.25 voxels, the largest tangent step
};

/// Raises the trust radius to twice the hand's movement, up to the ceiling. It never lowers it, unless the ceiling is lower.
///
/// motion    the HIP's movement since the last tick; the largest component counts
void renew_trust_radius(const Vec3<Voxel>& motion, StepMemory& memory);

/// After a tick whose steps have not come to the surface: halves the ceiling, and the trust radius becomes the ceiling.
void lower_trust(StepMemory& memory);
/// After a tick whose steps have come to the surface: doubles the ceiling, up to 1.25 voxels. The trust radius follows with the hand.
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
