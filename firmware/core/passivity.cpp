#include "firmware/core/passivity.h"

#include <algorithm>

namespace isotouch::core {

namespace {

using PerEnergy = Fixed<Unit<-1, -1, 0, 0>, 20>;
constexpr PerEnergy kPerDebt = PerEnergy::of(5.0);  // 1 / kFullDebt
constexpr Mm kMostMove = Mm::of(16);
constexpr Newton kMostForce = Newton::of(8191);
constexpr Ratio kWhole = Ratio::of(1);
constexpr int kWorkBits = Newton::kFractionBits + Mm::kFractionBits - Energy::kFractionBits;

template <class Q>
Vec3<Q> within(const Vec3<Q>& v, Q limit) {
  const auto bounded = [limit](Q q) { return std::clamp(q, -limit, limit); };
  return {bounded(v.x), bounded(v.y), bounded(v.z)};
}

Energy work(const Vec3<Newton>& force, const Vec3<Mm>& way) {
  return Energy::from_raw(saturate32(round_shift(dot_raw(force, way), kWorkBits)));
}

/// What the spring can give back, ½ k s²; where its force is limited to the part r of k s, that is k s² r (1 - r/2).
Energy stored_energy(const Force& force) {
  const Energy whole = work(within(force.spring, kMostForce), within(force.stretch, Mm::of(1023)));
  const Ratio half = Ratio::from_raw(force.kept.raw() >> 1);
  return mul<Energy>(whole, mul<Ratio>(force.kept, kWhole - half));
}

}  // namespace

Damping injected_damping(const Passivity& passivity, const PassivityState& state) {
  const Energy debt = std::max(-state.balance, Energy{});
  return mul<Damping>(passivity.most, std::min(mul<Ratio>(debt, kPerDebt), kWhole));
}

void book_energy(const Vec3<Mm>& hip, const Force& force, const Vec3<Newton>& injected, const Passivity& passivity, PassivityState& state) {
  if (force.ramping) state = {};
  const Energy stored = stored_energy(force);
  if (state.begun) {
    const Vec3<Mm> way = within(hip - state.hip, kMostMove);
    const Vec3<Newton>& felt = state.forces[(state.tick - passivity.delay) & (PassivityState::kForces - 1)];
    const Energy brought = work(mul<Newton>(way, passivity.device) - felt, way);
    state.balance = std::min(state.balance + brought - (stored - state.stored), kMostSurplus);
  }
  const auto half = [](Newton f) { return Newton::from_raw(f.raw() >> 1); };
  state.hip = hip;
  state.injected = injected;
  state.stored = stored;
  state.begun = true;
  ++state.tick;
  state.forces[state.tick & (PassivityState::kForces - 1)] =
      force.newton - Vec3<Newton>{half(injected.x), half(injected.y), half(injected.z)};
}

}  // namespace isotouch::core
