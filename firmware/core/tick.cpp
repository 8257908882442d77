#include "firmware/core/tick.h"

#include "firmware/core/stiffness_at.h"

namespace isotouch::core {

namespace {

constexpr Mm kReach = Mm::of(512);              // of the input, each axis: three products of differences then fit 63 bits
constexpr Voxel kIndexReach = Voxel::of(8191);  // twice the largest grid: a difference of two fits 2^30

Vec3<Mm> clamp_to_reach(const Vec3<Mm>& hip) { return within(hip, kReach); }

Vec3<Voxel> to_index(const Vec3<Mm>& point, const BlobView& field) {
  return within(mul<Voxel>(point - field.origin, field.inverse_edge), kIndexReach);
}

Vec3<Mm> to_workspace(const Vec3<Voxel>& index, const BlobView& field) { return mul<Mm>(index, field.edge) + field.origin; }

constexpr std::uint32_t when(bool condition, StatusBits bit) { return condition ? std::uint32_t{bit} : 0U; }

/// Forces against the hand's speed.
struct Damped {
  Vec3<Newton> force;     ///< all of it
  Vec3<Newton> injected;  ///< the passivity controller's part
};

/// Nothing is known of the speed as long as nobody asks for it.
Damped damp(const Vec3<Mm>& hip, bool fresh, const TickModel& model, TickState& state) {
  if (model.hand_damping <= Damping{} && !model.passivity.is_on()) {
    state.velocity = {};
    return {};
  }
  const Vec3<MmPerS> velocity = quiet_velocity(hip, fresh, model.rate, state.velocity);
  const Vec3<Newton> injected = damping_force(velocity, injected_damping(model.passivity, state.passivity));
  return {damping_force(velocity, model.hand_damping) + injected, injected};
}

/// What is felt is the proxy that friction holds.
void add_friction(Stiffness stiffness, const Friction& friction, FrictionState& state, Contact& contact) {
  if (!friction.is_on()) {
    state.holds = false;
    return;
  }
  const Vec3<Voxel> offset = friction_offset(contact, stiffness, friction, state);
  contact.proxy = contact.proxy + offset;
  contact.stretch = contact.stretch + offset;
}

}  // namespace

TickModel make_model(const TickSettings& settings, std::uint32_t period_ns, const BlobView& field) {
  return for_field(make_model(settings, period_ns), field);
}

TickModel make_model(const TickSettings& settings, std::uint32_t period_ns) {
  TickModel model;
  model.settings = settings;
  model.coupling = make_coupling(settings, period_ns);
  model.rate = PerSecond::from_raw(static_cast<std::int32_t>(1'000'000'000LL * (1 << PerSecond::kFractionBits) / period_ns));
  model.hand_damping = settings.hand_damping;
  model.friction = {settings.friction, mul<DampingPerTick>(settings.friction_damping, model.rate)};
  model.passivity = {settings.passivity, mul<DampingPerTick>(settings.device_damping, model.rate), settings.delay_ticks};
  return model;
}

void retune(const TickSettings& settings, TickModel& model) {
  model.settings = settings;
  if (settings.stiffness > Stiffness{}) model.coupling.stiffness = settings.stiffness;
  model.coupling.damping = mul<DampingPerTick>(settings.damping, model.rate);
  model.coupling.force_limit = settings.force_limit;
  model.hand_damping = settings.hand_damping;
  model.friction = {settings.friction, mul<DampingPerTick>(settings.friction_damping, model.rate)};
  model.passivity.most = settings.passivity;
}

TickModel for_field(const TickModel& prepared, const BlobView& field) {
  TickModel model = prepared;
  model.coupling = for_field(prepared.coupling, field);
  return model;
}

TickOutput tick(const TickInput& in, const BlobView& field, const TickModel& model, TickState& state) {
  const Vec3<Mm> hip = clamp_to_reach(in.hip);
  Contact contact = step_proxy(to_index(hip, field), field, state.proxy);
  const Stiffness stiffness = stiffness_at(contact.proxy, field, model.coupling.stiffness);
  add_friction(stiffness, model.friction, state.friction, contact);
  const Damped damped = damp(hip, in.fresh, model, state);
  const Force force = couple(contact, stiffness, model.coupling, state.coupling, damped.force);
  if (model.passivity.is_on()) book_energy(hip, force, damped.injected, model.passivity, state.passivity);

  const std::uint32_t status = when(contact.touching, kContact) | when(contact.following, kFollowing) |
                               when(contact.outside_grid, kOutsideGrid) | when(contact.held_inside, kHeldInside) |
                               when(force.ramping, kRamping) | when(force.limited, kForceLimited) | when(!in.fresh, kStale) |
                               when(!(hip == in.hip), kInputClamped) |
                               when(contact.touching && !(damped.injected == Vec3<Newton>{}), kDamped);
  return {contact.touching || contact.following ? to_workspace(contact.proxy, field) : hip, force.newton, {}, 0, status};
}

}  // namespace isotouch::core
