#include "firmware/core/proxy.h"

namespace isotouch::core {

namespace {

// One Newton step from the last sample must be shorter than this for its end to count as on the surface: within 0.05 voxel of it, by measurement in
// creases of 40 degrees at up to 3 voxels a tick.
constexpr Voxel kSettled = Voxel::of(0.15);
// A point so close in front of the surface counts as it is, and is never inside. On a fast way round an edge the steps often end there.
constexpr Voxel kNear = Voxel::of(0.4);

bool is_short(const Vec3<Voxel>& step, Voxel limit) {
  const auto within = [limit](Voxel v) { return v <= limit && v >= -limit; };
  return within(step.x) && within(step.y) && within(step.z);
}

}  // namespace

Contact rest_at(const Vec3<Voxel>& hip, const FieldView& field, ProxyState& state) {
  state.hip = state.point = hip;
  state.sample = sample_field(field, hip);
  state.mode = state.sample.distance < Voxel{} ? ProxyMode::kHeldInside : ProxyMode::kFree;
  Contact contact;
  contact.proxy = hip;
  contact.held_inside = state.mode == ProxyMode::kHeldInside;
  contact.outside_grid = state.sample.outside_grid;
  return contact;
}

Contact step_proxy(const Vec3<Voxel>& hip, const FieldView& field, ProxyState& state) {
  if (state.mode == ProxyMode::kUnplaced || state.mode == ProxyMode::kHeldInside) return rest_at(hip, field, state);

  renew_trust_radius(hip - state.hip, state.steps);
  state.hip = hip;
  for (int step = 0; step < kProxySteps; ++step) {
    if (state.unsettled) {
      state.point = state.proxy;
      state.unsettled = false;
    } else {
      step_towards(hip, state.sample, field.inverse_slope, state.steps, state.point);
    }
    sample_field(field, state.point, state.sample);
  }

  SurfaceProjection projection;
  project_on_surface(hip, state.point, state.sample, projection);
  const bool on_surface = is_short(projection.step, kSettled);
  const bool settled = on_surface || (state.sample.distance > Voxel{} && is_short(projection.step, kNear));
  const bool was_touching = state.mode == ProxyMode::kContact;
  Contact contact;
  contact.touching = (settled || was_touching) && projection.hip_behind;
  contact.proxy = !contact.touching ? state.point : on_surface ? state.point + projection.step : settled ? state.point : state.proxy;
  state.proxy = contact.proxy;
  state.unsettled = contact.touching && !settled;
  state.unsettled ? lower_trust(state.steps) : raise_trust(state.steps);
  if (contact.touching) contact.deflection = contact.proxy - hip;
  contact.following = !contact.touching && !(state.point == hip);
  contact.outside_grid = state.sample.outside_grid;
  state.mode = contact.touching ? ProxyMode::kContact : ProxyMode::kFree;
  return contact;
}

}  // namespace isotouch::core
