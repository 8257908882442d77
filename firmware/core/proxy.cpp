#include "firmware/core/proxy.h"

#include "firmware/core/surface_step.h"

namespace isotouch::core {

namespace {

constexpr Voxel kArrival = Voxel::of(0.25);   // contact begins when the proxy is this close to the surface

/// Begins, or goes on, without a surface to hold: the proxy is the HIP, and contact is possible once the HIP is outside.
Contact rest_at(const Vec3<Voxel>& hip, const BlobView& field, ProxyState& state) {
  state.point = hip;
  state.sample = sample_field(field, hip);
  state.mode = state.sample.distance < Voxel{} ? ProxyMode::kHeldInside : ProxyMode::kFree;
  Contact contact;
  contact.proxy = hip;
  contact.held_inside = state.mode == ProxyMode::kHeldInside;
  contact.outside_grid = state.sample.outside_grid;
  return contact;
}

}  // namespace

Contact step_proxy(const Vec3<Voxel>& hip, const BlobView& field, ProxyState& state) {
  if (state.mode == ProxyMode::kUnplaced || state.mode == ProxyMode::kHeldInside) return rest_at(hip, field, state);

  for (int step = 0; step < kProxySteps; ++step) {
    state.point = state.point + step_towards(hip, state.point, state.sample);
    state.sample = sample_field(field, state.point);
  }

  const bool near_surface = state.mode == ProxyMode::kContact || state.sample.distance <= kArrival;
  Contact contact;
  contact.touching = near_surface && is_behind_surface(hip, state.point, state.sample);
  contact.proxy = contact.touching ? state.point + step_onto_surface(state.sample) : state.point;
  if (contact.touching) contact.stretch = contact.proxy - hip;
  contact.following = !contact.touching && !(state.point == hip);
  contact.outside_grid = state.sample.outside_grid;
  state.mode = contact.touching ? ProxyMode::kContact : ProxyMode::kFree;
  return contact;
}

}  // namespace isotouch::core
