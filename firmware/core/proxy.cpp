#include "firmware/core/proxy.h"

#include <algorithm>

#include "firmware/core/longer.h"
#include "shared/roots.h"

namespace isotouch::core {

namespace {

// One Newton step from the last sample must be shorter than this for its end to count as on the surface: within 0.05 voxel of it, by measurement in
// creases of 40 degrees at up to 3 voxels a tick.
constexpr Voxel kSettled = Voxel::of(0.15);

// A proxy that was held goes on at twice the hand's pace and this much more in a tick, which is 0.19 m/s on a grid of 186 over 70 mm.
constexpr Voxel kCatchUp = Voxel::of(0.5);
constexpr Voxel kPaceLimit = Voxel::of(1024);  // a hand that leaps is stopped elsewhere; twice this fits

bool is_short(const Vec3<Voxel>& step) {
  const auto within = [](Voxel v) { return v <= kSettled && v >= -kSettled; };
  return within(step.x) && within(step.y) && within(step.z);
}

/// The largest of a way's components: its length, to within a factor of 1.7.
Voxel size_of(const Vec3<Voxel>& way) {
  const auto size = [](Voxel v) { return v < Voxel{} ? -v : v; };
  return std::max({size(way.x), size(way.y), size(way.z)});
}

/// From where the proxy was held towards the place that was found, no further than a hand moves in a tick: a released proxy does not leap.
Vec3<Voxel> catch_up(const Vec3<Voxel>& found, const Vec3<Voxel>& motion, ProxyState& state) {
  const Vec3<Voxel> way = found - state.proxy;
  const Voxel pace = std::min(size_of(motion), kPaceLimit);
  const Voxel limit = pace + pace + kCatchUp;
  state.held = is_longer(way, limit);
  if (!state.held) return found;
  const Reciprocal inverse_length = inverse_root_of_positive(static_cast<std::uint64_t>(dot_raw(way, way)));
  const auto share = Ratio::from_raw(static_cast<std::int32_t>(share_of_root(limit.raw(), inverse_length)));
  return state.proxy + part_of(way, share);
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

  const Vec3<Voxel> motion = hip - state.hip;
  renew_trust_radius(motion, state.steps);
  state.hip = hip;
  for (int step = 0; step < kProxySteps; ++step) {
    step_towards(hip, state.sample, field.inverse_slope, state.steps, state.point);
    sample_field(field, state.point, state.sample);
  }

  SurfaceProjection projection;
  project_on_surface(hip, state.point, state.sample, projection);
  const bool settled = is_short(projection.step);
  const bool was_touching = state.mode == ProxyMode::kContact;
  Contact contact;
  contact.touching = (settled || was_touching) && projection.hip_behind;
  if (!contact.touching) {
    contact.proxy = state.point;
    state.held = false;
  } else if (!settled) {
    contact.proxy = state.proxy;
    state.held = true;
  } else {
    const Vec3<Voxel> found = state.point + projection.step;
    contact.proxy = state.held ? catch_up(found, motion, state) : found;
  }
  state.proxy = contact.proxy;
  if (contact.touching) contact.deflection = contact.proxy - hip;
  contact.following = !contact.touching && !(state.point == hip);
  contact.outside_grid = state.sample.outside_grid;
  state.mode = contact.touching ? ProxyMode::kContact : ProxyMode::kFree;
  return contact;
}

}  // namespace isotouch::core
