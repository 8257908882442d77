/// One step of the proxy, from one sample of the field: the mathematics of `step_proxy`, without its loop.
///
/// Index coordinates throughout. tick: yes, every function: constant cost, no division, no failure.
#pragma once

#include "firmware/core/field_sampler.h"
#include "shared/units.h"
#include "shared/vec3.h"

namespace isotouch::core {

/// Is the HIP behind the plane that the sample at `point` predicts for the surface, φ + g·(hip - point) < 0?
bool is_behind_surface(const Vec3<Voxel>& hip, const Vec3<Voxel>& point, const FieldSample& sample);

/// From the sampled point straight to the surface, -φ g / |g|²: one Newton step along the gradient.
Vec3<Voxel> step_onto_surface(const FieldSample& sample);

/// The step from `point` towards the point of the surface, or of free space, closest to the HIP.
///
/// In free space: to the HIP. Where the HIP is behind the surface: onto the surface and along it, by one step of sequential quadratic programming
/// with the field's second derivatives. Never longer than is safe: the distance to the surface and one voxel more; less by twice the depth where the
/// point is inside, so that steps in an acute crease cannot add up to a passage.
Vec3<Voxel> step_towards(const Vec3<Voxel>& hip, const Vec3<Voxel>& point, const FieldSample& sample);

}  // namespace isotouch::core
