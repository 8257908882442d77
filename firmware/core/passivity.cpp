#include "firmware/core/passivity.h"

#include <algorithm>

namespace isotouch::core {

namespace {

using PerEnergy = Fixed<Unit<-1, -1, 0, 0>, 20>;
constexpr PerEnergy kPerDebt = PerEnergy::of(5.0);  // 1 / kFullDebt
constexpr Mm kMaxMove = Mm::of(16);
constexpr Newton kMaxForce = Newton::of(8191);
constexpr Ratio kWhole = Ratio::of(1);
constexpr int kWorkBits = Newton::kFractionBits + Mm::kFractionBits - Energy::kFractionBits;

Energy work(const Vec3<Newton>& force, const Vec3<Mm>& way) {
  return Energy::from_raw(saturate32(round_shift(dot_raw(force, way), kWorkBits)));
}

/// What the spring can give back, ½ k s²; where its force is limited to the part r of k s, that is k s² r (1 - r/2).
Energy stored_energy(const Force& force) {
  const Energy whole = work(within(force.spring, kMaxForce), within(force.deflection, Mm::of(1023)));
  const Ratio half = Ratio::from_raw(force.kept.raw() >> 1);
  return part_of(whole, part_of(force.kept, kWhole - half));
}

}  // namespace

Damping injected_damping(const Passivity& passivity, const PassivityState& state) {
  return part_of(passivity.most, within(mul<Ratio>(-state.balance, kPerDebt), Ratio{}, kWhole));
}

void forget(PassivityState& state) {
  state.balance = {};
  state.tick = 0;
  state.begun = false;
}

void book_energy(const Vec3<Mm>& way, const Force& force, const Vec3<Newton>& injected, const Passivity& passivity, PassivityState& state) {
  if (force.ramping) forget(state);
  const Energy stored = stored_energy(force);
  if (state.begun) {
    const Vec3<Mm> moved = within(way, kMaxMove);
    const bool felt_any = state.tick > passivity.delay;
    const Vec3<Newton> felt = felt_any ? state.forces[(state.tick - passivity.delay) & (PassivityState::kForces - 1)] : Vec3<Newton>{};
    const Energy brought = work(mul<Newton>(moved, passivity.device) - felt, moved);
    state.balance = std::min(state.balance + brought - (stored - state.stored), kMaxSurplus);
  }
  const auto half = [](Newton f) { return Newton::from_raw(f.raw() >> 1); };
  state.stored = stored;
  state.begun = true;
  state.tick = static_cast<std::uint8_t>(state.tick < 2 * PassivityState::kForces - 1 ? state.tick + 1 : PassivityState::kForces);
  state.forces[state.tick & (PassivityState::kForces - 1)] =
      force.newton - Vec3<Newton>{half(injected.x), half(injected.y), half(injected.z)};
}

}  // namespace isotouch::core
