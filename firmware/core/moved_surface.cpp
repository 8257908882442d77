#include "firmware/core/moved_surface.h"

#include "firmware/core/direction.h"

namespace isotouch::core {

namespace {

// A proxy in contact is this deep at most where the surface has hardly moved; there the steps lead out again.
constexpr Voxel kStillOn = Voxel::of(0.25);
// So far in front it still touches, as in `step_proxy`.
constexpr Voxel kNear = Voxel::of(0.4);

Vec3<Voxel> as_lengths(const Vec3<Slope>& slope) {
  static_assert(Slope::kFractionBits == Voxel::kFractionBits);
  return {Voxel::from_raw(slope.x.raw()), Voxel::from_raw(slope.y.raw()), Voxel::from_raw(slope.z.raw())};
}

/// Within 60 degrees of the old normal. Components of a gradient are below 2^21, so the squares are below 2^45.
bool faces_along(const Vec3<Slope>& gradient, const Vec3<Ratio>& normal) {
  const Vec3<Voxel> g = as_lengths(gradient);
  const std::int64_t with = along(g, normal).raw();
  return with > 0 && 4 * with * with >= dot_raw(g, g);
}

}  // namespace

void keep_side(const FieldView& field, ProxyState& state) {
  if (state.mode == ProxyMode::kUnplaced || state.mode == ProxyMode::kHeldInside) return;
  const bool touched = state.mode == ProxyMode::kContact;
  const Vec3<Voxel> from = touched ? state.proxy : state.point;
  const Vec3<Ratio> normal = direction(as_lengths(state.sample.gradient));

  state.mode = ProxyMode::kHeldInside;
  for (int rise = 0; rise <= kMostRise; ++rise) {
    const Vec3<Voxel> point = from + reaching(Voxel::from_raw(rise << Voxel::kFractionBits), normal);
    const FieldSample sample = sample_field(field, point);
    const bool faces = faces_along(sample.gradient, normal);
    const bool still_on = rise == 0 && touched && faces && sample.distance >= -kStillOn && sample.distance <= kNear;
    const bool in_front = sample.distance >= Voxel{} && (faces || rise == 0);
    if (state.mode != ProxyMode::kHeldInside || (!still_on && !in_front)) continue;
    state.mode = still_on ? ProxyMode::kContact : ProxyMode::kFree;
    state.point = state.proxy = point;
    state.sample = sample;
  }
  state.steps = {};
  state.unsettled = false;
}

}  // namespace isotouch::core
