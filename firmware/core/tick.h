/// The one function that the hand feels: inputs and field in, force out. Pure and integer, so that a recorded trace replays to the bit.
#pragma once

#include "firmware/core/coupling.h"
#include "firmware/core/friction.h"
#include "firmware/core/hand_damping.h"
#include "firmware/core/passivity.h"
#include "firmware/core/proxy.h"
#include "shared/blob.h"
#include "shared/tick_io.h"

namespace isotouch::core {

/// What does not change between ticks, prepared once so that the tick needs no division.
struct TickModel {
  TickSettings settings;
  Coupling coupling;
  Friction friction;
  Damping hand_damping;
  Passivity passivity;
  PerSecond rate;  ///< ticks a second
};

/// settings     as in the trace's header
/// period_ns    the tick period, 100,000 to 4,000,000
/// field        gives the largest stiffness when the settings name none
/// tick         no: divides
TickModel make_model(const TickSettings& settings, std::uint32_t period_ns, const BlobView& field);

/// The same in two halves, for a field that comes later: this one divides, `for_field` does not.
TickModel make_model(const TickSettings& settings, std::uint32_t period_ns);
/// prepared     by the function above
/// tick         yes
TickModel for_field(const TickModel& prepared, const BlobView& field);

/// Takes over the settings that may change while they are felt; a stiffness of 0 leaves the one that is felt.
///
/// tick         yes
void retune(const TickSettings& settings, TickModel& model);

/// Everything a tick remembers; a default one is the state before the first tick.
struct TickState {
  ProxyState proxy;
  CouplingState coupling;
  FrictionState friction;
  QuietVelocityState velocity;
  PassivityState passivity;
};

/// One tick: where the hand is → what it feels.
///
/// in        HIP in the workspace, ±512 mm; beyond, it is clamped and kInputClamped is set
/// field     a checked view, the same in every tick of a state's life
/// returns   proxy, force and status; the force is zero in every tick without contact
/// fails     never
/// tick      yes: constant loop counts, no division, no allocation
TickOutput tick(const TickInput& in, const BlobView& field, const TickModel& model, TickState& state);

}  // namespace isotouch::core
