/// What the hand feels of the field: where the hand is and how it moves → proxy and force. Pure and integer, so that a recorded trace replays to the bit.
#pragma once

#include "firmware/core/coupling.h"
#include "firmware/core/friction.h"
#include "firmware/core/motion.h"
#include "firmware/core/passivity.h"
#include "firmware/core/proxy.h"
#include "firmware/core/spring_energy.h"
#include "shared/field_view.h"
#include "shared/tick_io.h"

namespace isotouch::core {

/// Largest coordinate of the HIP on each axis; the sum of three products of differences then fits 63 bits.
inline constexpr Mm kReach = Mm::of(512);

/// What does not change between ticks, prepared once so that the tick needs no division.
struct RenderModel {
  TickSettings settings;
  Coupling coupling;
  Friction friction;
  Damping hand_damping;
  Passivity passivity;
  PerSecond rate;  ///< ticks a second

  /// Does anything need the hand's quiet velocity?
  bool damps() const { return hand_damping > Damping{} || passivity.is_on(); }
};

/// A model for any field.
///
/// settings     as in the trace's header
/// rate         ticks a second, see `MotionModel`
/// tick         no: divides
RenderModel make_render_model(const TickSettings& settings, PerSecond rate);
/// The same for a field, which gives the largest stiffness where the settings name none.
///
/// tick         yes
RenderModel for_field(const RenderModel& any_field, const FieldView& field);

/// Takes over the settings that may change while they are felt; a stiffness of 0 leaves the one that is felt.
///
/// tick         yes
void retune(const TickSettings& settings, RenderModel& model);

/// Everything that rendering remembers; a default one is the state before the first tick.
struct RenderState {
  ProxyState proxy;
  SpringState spring;
  CouplingState coupling;
  FrictionState friction;
  PassivityState passivity;
};

/// What is felt.
struct Rendering {
  Vec3<Mm> proxy;  ///< workspace frame; the HIP where there is neither contact nor a proxy on its way
  Vec3<Newton> force;
  bool touching = false;
  std::uint32_t status = 0;  ///< StatusBits
};

/// Renders the contact: proxy, friction, stiffness there, damping, coupling, energy balance.
///
/// motion    of the hand, HIP within kReach
/// field     a checked view, the same in every tick of a state's life; another one on the same grid after `move_surface`
/// returns   proxy, force and status; the force is zero in every tick without contact, unless one is being released (kLagging)
/// fails     never
/// tick      yes: constant loop counts, no division, no allocation
Rendering render(const Motion& motion, const FieldView& field, const RenderModel& model, RenderState& state);

/// Before the tick in which the surface has moved by itself: the proxy stays on its side of it, and the force begins to follow.
///
/// field     patched, of the default method, on the grid of the one before
/// tick      yes: constant cost, four samples
void move_surface(const FieldView& field, const RenderModel& model, RenderState& state);

/// The second half of `render`: what a hand feels of a contact that is known. The proxy may be anybody's.
///
/// contact   in the field's index coordinates, within ±8191 voxels; leaning and friction move it
/// motion    of the hand, HIP within kReach
/// fails     never
/// state     its own proxy is left alone; where the field's stiffness varies, `proxy.sample` says how the surface bends there
/// tick      yes, as `render`
Rendering feel(Contact& contact, const Motion& motion, const FieldView& field, const RenderModel& model, RenderState& state);

/// A tick without a device: the position of a hand goes in, the force that it would feel comes out.
struct PositionModel {
  MotionModel motion;
  RenderModel render;
};
struct PositionState {
  MotionState motion;
  RenderState render;
};

/// device       its play counts
/// tick         no: divides
PositionModel make_position_model(const DeviceModel& device, const TickSettings& settings, std::uint32_t period_ns, const FieldView& field);

/// in        a position; beyond kReach it is clamped and kInputClamped is set. With kRequestMoved the field is the patched one from here on
/// tick      yes
Output render_position(const Input& in, const FieldView& field, const PositionModel& model, PositionState& state);

}  // namespace isotouch::core
