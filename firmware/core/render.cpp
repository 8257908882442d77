#include "firmware/core/render.h"

#include "firmware/core/descent_proxy.h"
#include "firmware/core/index_frame.h"
#include "firmware/core/moved_surface.h"

namespace isotouch::core {

namespace {

constexpr std::uint32_t when(bool condition, StatusBits bit) { return condition ? std::uint32_t{bit} : 0U; }

Contact follow(const Vec3<Voxel>& hip, const FieldView& field, ProxyState& state) {
  return field.method == Method::kPublished ? descend_proxy(hip, field, state) : step_proxy(hip, field, state);
}

/// Forces against the hand's speed.
struct Damped {
  Vec3<Newton> force;     ///< all of it
  Vec3<Newton> injected;  ///< the passivity controller's part
};

Damped damp(const Vec3<MmPerS>& velocity, const RenderModel& model, const PassivityState& passivity) {
  if (!model.damps()) return {};
  const Vec3<Newton> injected = damping_force(velocity, injected_damping(model.passivity, passivity));
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
  contact.deflection = contact.deflection + offset;
}

}  // namespace

RenderModel make_render_model(const TickSettings& settings, PerSecond rate) {
  RenderModel model;
  model.coupling = make_coupling(settings, rate);
  model.passivity = {{}, per_tick(settings.device_damping, rate), settings.delay_ticks};
  model.rate = rate;
  retune(settings, model);
  return model;
}

void retune(const TickSettings& settings, RenderModel& model) {
  model.settings = settings;
  if (settings.stiffness > Stiffness{}) model.coupling.stiffness = settings.stiffness;
  model.coupling.damping = per_tick(settings.damping, model.rate);
  model.coupling.force_limit = settings.force_limit;
  model.hand_damping = settings.hand_damping;
  model.friction = {settings.friction, per_tick(settings.friction_damping, model.rate)};
  model.passivity.most = settings.passivity;
}

RenderModel for_field(const RenderModel& any_field, const FieldView& field) {
  RenderModel model = any_field;
  model.coupling = for_field(any_field.coupling, field);
  return model;
}

Rendering feel(Contact& contact, const Motion& motion, const FieldView& field, const RenderModel& model, RenderState& state) {
  lean_to_the_softer(state.proxy.sample, state.spring, contact);
  add_friction(part_of(model.coupling.stiffness, state.spring.felt.part), model.friction, state.friction, contact);
  const Stiffness stiffness = felt_stiffness(contact, field, model.coupling.stiffness, state.spring);
  const Damped damped = damp(motion.quiet, model, state.passivity);
  const bool lagging = state.coupling.lag.on;
  const Force force = lagging ? couple_lagging(contact, motion.way, contact.following || state.proxy.unsettled, stiffness, model.coupling,
                                               state.coupling, damped.force)
                              : couple(contact, motion.way, stiffness, model.coupling, state.coupling, damped.force);
  if (model.passivity.is_on()) book_energy(motion.way, force, damped.injected, model.passivity, state.passivity);

  const std::uint32_t status = when(contact.touching, kContact) | when(contact.following, kFollowing) |
                               when(contact.outside_grid, kOutsideGrid) | when(contact.held_inside, kHeldInside) |
                               when(force.ramping, kRamping) | when(force.limited, kForceLimited) |
                               when(contact.touching && !(damped.injected == Vec3<Newton>{}), kDamped) | when(lagging, kLagging);
  const bool away = contact.touching || contact.following;
  return {away ? to_workspace(contact.proxy, field) : motion.hip, force.newton, contact.touching, status};
}

void move_surface(const FieldView& field, const RenderModel& model, RenderState& state) {
  begin_lag(part_of(model.coupling.stiffness, state.spring.felt.part), model.coupling, state.coupling);
  state.spring.holds = false;  // its energy is that of the old surface; a grip stays where it is
  keep_side(field, state.proxy);
}

// Flat: a call of `feel` would cost the tick 30 instructions.
[[gnu::flatten]] Rendering render(const Motion& motion, const FieldView& field, const RenderModel& model, RenderState& state) {
  Contact contact = follow(to_index(motion.hip, field), field, state.proxy);
  return feel(contact, motion, field, model, state);
}

PositionModel make_position_model(const DeviceModel& device, const TickSettings& settings, std::uint32_t period_ns,
                                  const FieldView& field) {
  const MotionModel motion = make_motion_model(device, period_ns);
  return {motion, for_field(make_render_model(settings, motion.rate), field)};
}

Output render_position(const Input& in, const FieldView& field, const PositionModel& model, PositionState& state) {
  if ((in.requests & kRequestMoved) != 0) move_surface(field, model.render, state.render);
  const Vec3<Mm> hip = within(in.hip, kReach);
  const Motion motion = track_motion(hip, in.fresh, model.render.damps(), model.motion, state.motion);
  const Rendering felt = render(motion, field, model.render, state.render);
  Output out;
  out.hip = hip;
  out.proxy = felt.proxy;
  out.force = felt.force;
  out.status = felt.status | when(!in.fresh, kStale) | when(!(hip == in.hip), kInputClamped);
  out.buttons = in.buttons;
  return out;
}

}  // namespace isotouch::core
