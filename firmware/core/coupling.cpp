#include "firmware/core/coupling.h"

#include "shared/roots.h"

namespace isotouch::core {

namespace {

/// How far a spring is stretched that gives this force.
Vec3<Mm> stretch_of(const Vec3<Newton>& force, Stiffness stiffness) {
  constexpr int kBits = Stiffness::kFractionBits + Mm::kFractionBits - Newton::kFractionBits;
  const Reciprocal over = reciprocal32(static_cast<std::uint32_t>(stiffness.raw()));  // below 2^31, its shift is 31 at least
  const auto part = [&](Newton f) { return Mm::from_raw(saturate32((std::int64_t{f.raw()} * over.mantissa) >> (over.shift - kBits))); };
  return {part(force.x), part(force.y), part(force.z)};
}

struct Limited {
  Vec3<Newton> newton;
  bool limited;
  Ratio kept;  // the part of the length that is left
};

/// Shortens a force to the limit, direction kept, to within two units of the last place. Components are clamped to ±8191 N first (2^29), so that
/// three squares fit 63 bits. Inline: a call would cost every tick 30 instructions.
[[gnu::always_inline]] inline Limited limited_length(const Vec3<Newton>& force, Newton limit) {
  const Vec3<Newton> f = within(force, Newton::of(8191));
  const std::int64_t square = dot_raw(f, f);
  const bool limited = square > std::int64_t{limit.raw()} * limit.raw();
  if (!limited) return {force, false, Ratio::of(1)};
  const Reciprocal inverse_length = inverse_root_of_positive(static_cast<std::uint64_t>(square));
  const auto kept = Ratio::from_raw(static_cast<std::int32_t>(share_of_root(limit.raw(), inverse_length)));
  return {part_of(f, kept), true, kept};
}

}  // namespace

Coupling for_field(const Coupling& prepared, const FieldView& field) {
  Coupling coupling = prepared;
  coupling.edge = field.edge;
  if (coupling.stiffness <= Stiffness{}) coupling.stiffness = field.stiffness;
  return coupling;
}

Coupling make_coupling(const TickSettings& settings, PerSecond rate) {
  Coupling coupling;
  coupling.stiffness = settings.stiffness;
  coupling.damping = per_tick(settings.damping, rate);
  coupling.force_limit = settings.force_limit;
  coupling.ramp_ticks = settings.ramp_ticks;
  coupling.ramp_part = RampPart::from_raw(settings.ramp_ticks == 0 ? 0 : static_cast<std::int32_t>((1U << 30) / settings.ramp_ticks));
  return coupling;
}

Force couple(const Contact& contact, const Vec3<Mm>& way, Stiffness stiffness, const Coupling& coupling, CouplingState& state,
             const Vec3<Newton>& damping) {
  const Vec3<Mm> deflection = mul<Mm>(contact.deflection, coupling.edge);
  const Vec3<Mm> change = deflection - state.last_deflection;
  state.last_deflection = deflection;
  state.last_way = way;

  const bool arrived = !contact.following && !contact.held_inside;
  const bool in_ramp = contact.touching && state.ramp < coupling.ramp_ticks;
  state.ramp = !arrived ? 0 : in_ramp ? state.ramp + 1 : coupling.ramp_ticks;

  state.lag.damper = {};
  if (!contact.touching) return {};
  const Vec3<Newton> spring = mul<Newton>(deflection, stiffness);
  state.lag.damper = mul<Newton>(change, coupling.damping);
  const Vec3<Newton> full = spring + state.lag.damper + damping;
  const auto part = static_cast<std::int32_t>(state.ramp) * coupling.ramp_part.raw();  // at most 2^30: ramp <= ramp_ticks
  const Limited force = limited_length(in_ramp ? part_of(full, RampPart::from_raw(part)) : full, coupling.force_limit);
  state.lag.limited = force.limited;
  return {force.newton, force.limited, in_ramp, deflection, spring, force.kept};
}

void begin_lag(Stiffness stiffness, const Coupling& coupling, CouplingState& state) {
  Vec3<Newton> spring = mul<Newton>(state.last_deflection, stiffness);
  if (state.ramp < coupling.ramp_ticks) {
    const auto part = RampPart::from_raw(static_cast<std::int32_t>(state.ramp) * coupling.ramp_part.raw());
    spring = part_of(spring, part);
    state.lag.damper = part_of(state.lag.damper, part);
  }
  surface_moved(spring, state.lag);
}

Force couple_lagging(const Contact& contact, const Vec3<Mm>& way, bool arriving, Stiffness stiffness, const Coupling& coupling,
                     CouplingState& state, const Vec3<Newton>& damping) {
  const Vec3<Mm> deflection = mul<Mm>(contact.deflection, coupling.edge);
  const Vec3<Mm> change = deflection - state.last_deflection;
  Lag& lag = state.lag;
  LagInput in;
  in.target = mul<Newton>(deflection, stiffness);
  in.step = mul<Newton>(change, stiffness);
  in.by_hand = mul<Newton>(way, stiffness);
  if (coupling.damping > DampingPerTick{}) {  // off, it takes no time
    if (contact.touching) in.damper = mul<Newton>(change, coupling.damping);
    in.gain = mul<Newton>(way - state.last_way, coupling.damping);
  }
  in.others = damping;
  in.touched = !(state.last_deflection == Vec3<Mm>{});
  in.touching = contact.touching;
  in.arriving = arriving;
  in.limited = lag.felt;
  if (lag.limited && (lag.moved || !contact.touching)) {
    const Vec3<Newton> dampers = in.touched ? lag.damper + let_through(damping, lag) : Vec3<Newton>{};
    in.limited = limited_length(lag.felt + dampers, coupling.force_limit).newton - dampers;
    if (dot_raw(in.limited, lag.felt) < 0) in.limited = {};  // the dampers alone are beyond the limit
  }
  state.last_deflection = deflection;
  state.last_way = way;
  state.ramp = coupling.ramp_ticks;

  const Vec3<Newton> spring = follow_target(in, lag);
  const Vec3<Newton> full = spring + lag.damper;
  const Limited force = limited_length(contact.touching ? full + let_through(damping, lag) : full, coupling.force_limit);
  lag.limited = force.limited;
  return {force.newton, force.limited, false, stretch_of(spring, stiffness), spring, force.kept};
}

}  // namespace isotouch::core
