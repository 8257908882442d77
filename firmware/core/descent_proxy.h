/// The proxy of the published method, for a field that was built by it: a descent by fixed steps instead of `step_proxy`.
///
/// Outside the object the proxy is the HIP. Inside it minimises ½|p - h|² + (λ/2) φ(p)², by kDescentSteps steps of
///
///     p ← p - γ (p - h) - γ λ φ(p) ∇φ(p)
///
/// It stays below the surface by 1 / (1 + λ|∇φ|²) of the depth, and it may pass thin parts: that is how the paper has it. DECISIONS 13 gives the reason for
/// each number that the paper leaves open; host/evaluate/descent_tick.h is the same in floating point.
///
/// source    Sreeni K. G., Distance Field based Haptic Rendering of Scattered Oriented Points, section 3.3, equations 5 to 9, and 3.4
#pragma once

#include "firmware/core/proxy.h"
#include "shared/field_view.h"
#include "shared/units.h"
#include "shared/vec3.h"

namespace isotouch::core {

inline constexpr int kDescentSteps = 143;      ///< a tick
inline constexpr Narrow kDescentPenalty = 10;  ///< λ; γ = 1 / (1 + 3λ)

/// Moves the proxy by a tick's steps.
///
/// hip       index coordinates, within ±8191 voxels
/// field     the same view in every tick of a state's life
/// returns   contact if φ(proxy) < 0 after the last step; otherwise the proxy is the HIP. On each axis, proxy and HIP are never further apart than the
///           HIP moved in this tick and 1280 voxels more, whatever the field holds
/// fails     never; a HIP that begins inside the object gives no contact until it has left
/// tick      yes: kDescentSteps + 1 samples, constant cost, no division
Contact descend_proxy(const Vec3<Voxel>& hip, const FieldView& field, ProxyState& state);

}  // namespace isotouch::core
