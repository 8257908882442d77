#include "firmware/core/tick.h"

#include <algorithm>

#include "firmware/core/stiffness_at.h"

namespace isotouch::core {

namespace {

constexpr Mm kReach = Mm::of(512);              // of the input, each axis: three products of differences then fit 63 bits
constexpr Voxel kIndexReach = Voxel::of(8191);  // twice the largest grid: a difference of two fits 2^30

Vec3<Mm> clamp_to_reach(const Vec3<Mm>& hip) {
  return {std::clamp(hip.x, -kReach, kReach), std::clamp(hip.y, -kReach, kReach), std::clamp(hip.z, -kReach, kReach)};
}

Vec3<Voxel> to_index(const Vec3<Mm>& point, const BlobView& field) {
  const Vec3<Voxel> index = mul<Voxel>(point - field.origin, field.inverse_edge);
  const auto bounded = [](Voxel v) { return std::clamp(v, -kIndexReach, kIndexReach); };
  return {bounded(index.x), bounded(index.y), bounded(index.z)};
}

Vec3<Mm> to_workspace(const Vec3<Voxel>& index, const BlobView& field) { return mul<Mm>(index, field.edge) + field.origin; }

constexpr std::uint32_t when(bool condition, StatusBits bit) { return condition ? std::uint32_t{bit} : 0U; }

}  // namespace

TickModel make_model(const TickSettings& settings, std::uint32_t period_ns, const BlobView& field) {
  return for_field(make_model(settings, period_ns), field);
}

TickModel make_model(const TickSettings& settings, std::uint32_t period_ns) { return {settings, make_coupling(settings, period_ns)}; }

TickModel for_field(const TickModel& prepared, const BlobView& field) { return {prepared.settings, for_field(prepared.coupling, field)}; }

TickOutput tick(const TickInput& in, const BlobView& field, const TickModel& model, TickState& state) {
  const Vec3<Mm> hip = clamp_to_reach(in.hip);
  const Contact contact = step_proxy(to_index(hip, field), field, state.proxy);
  const Stiffness stiffness = stiffness_at(contact.proxy, field, model.coupling.stiffness);
  const Force force = couple(contact, stiffness, model.coupling, state.coupling);

  TickOutput out;
  out.proxy = contact.touching || contact.following ? to_workspace(contact.proxy, field) : hip;
  out.force = force.newton;
  out.status = when(contact.touching, kContact) | when(contact.following, kFollowing) | when(contact.outside_grid, kOutsideGrid) |
               when(contact.held_inside, kHeldInside) | when(force.ramping, kRamping) | when(force.limited, kForceLimited) |
               when(!in.fresh, kStale) | when(!(hip == in.hip), kInputClamped);
  return out;
}

}  // namespace isotouch::core
