/// How fast the HIP moves: differences of fresh samples, smoothed.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>

#include "shared/units.h"
#include "shared/vec3.h"

namespace isotouch::core {

struct VelocityState {
  Vec3<Mm> last;
  Vec3<MmPerS> velocity;
  std::uint32_t ticks = 0;  ///< since `last`
  bool has_last = false;
};

/// A fourth, rounded.
constexpr MmPerS quarter(MmPerS whole) { return MmPerS::from_raw((whole.raw() >> 2) + ((whole.raw() >> 1) & 1)); }

/// Counts are coarse: one is 10 to 40 µm, at 1 kHz 10 to 40 mm/s. Each difference enters with a quarter, so noise is halved and a step takes eight samples
/// to come through to nine tenths.
///
/// hip       within ±1023 mm
/// fresh     a repeated sample says nothing: the velocity stays, the next difference is divided by the ticks that passed (8 at most)
/// rate      ticks a second
/// returns   the velocity, within ±524 m/s
/// tick      yes
/// source    first-order low-pass; Colgate and Brown 1994 on quantised differences
inline Vec3<MmPerS> hip_velocity(const Vec3<Mm>& hip, bool fresh, PerSecond rate, VelocityState& state) {
  static constexpr std::array<Ratio, 9> kParts = {Ratio::of(1),    Ratio::of(1),   Ratio::of(0.5),          Ratio::of(0.3333333333),
                                                  Ratio::of(0.25), Ratio::of(0.2), Ratio::of(0.1666666667), Ratio::of(0.1428571429),
                                                  Ratio::of(0.125)};
  state.ticks = std::min<std::uint32_t>(state.ticks + 1, 8);
  if (!fresh) return state.velocity;
  if (state.has_last) {
    const Vec3<Mm> moved = part_of(hip - state.last, kParts[state.ticks]);
    const Vec3<MmPerS> now = mul<MmPerS>(moved, rate);
    const Vec3<MmPerS> change = now - state.velocity;
    state.velocity = state.velocity + Vec3<MmPerS>{quarter(change.x), quarter(change.y), quarter(change.z)};
  }
  state.last = hip;
  state.ticks = 0;
  state.has_last = true;
  return state.velocity;
}

}  // namespace isotouch::core
