/// Did the HIP leap? The filtered velocity needs some samples to tell a hand that is too fast; one sample is enough to tell that no hand moved so.
#pragma once

#include <algorithm>
#include <cstdint>

#include "firmware/core/longer.h"
#include "shared/device_model.h"
#include "shared/units.h"
#include "shared/vec3.h"

namespace isotouch::core {

struct MoveState {
  Vec3<Mm> last;
  std::uint32_t ticks = 0;  ///< since `last`
  bool has_last = false;
};

/// The way of a tick at twice the speed limit, at most 100 mm.
///
/// tick      no: divides
inline Mm make_largest_move(const DeviceModel& device, std::uint32_t period_ns) {
  constexpr int kShift = Mm::kFractionBits - MmPerS::kFractionBits;
  const std::int64_t way =
      2 * std::int64_t{device.speed_limit.raw()} * period_ns * (1 << kShift) / 1'000'000'000;  // below 2^60 before it is divided
  return Mm::from_raw(saturate32(std::clamp(way, std::int64_t{1}, std::int64_t{Mm::of(100).raw()})));
}

/// hip       within ±1023 mm
/// fresh     a repeated sample says nothing; the next one may come from as much farther away as ticks passed, eight at most
/// returns   true in the tick of the leap alone: what comes after is judged from there
/// tick      yes
inline bool is_leap(const Vec3<Mm>& hip, bool fresh, Mm largest_move, MoveState& state) {
  state.ticks = std::min<std::uint32_t>(state.ticks + 1, 8);
  if (!fresh) return false;
  const auto most = Mm::from_raw(largest_move.raw() * static_cast<std::int32_t>(state.ticks));  // at most 800 mm
  const bool leapt = state.has_last && is_longer(hip - state.last, most);
  state = {hip, 0, true};
  return leapt;
}

}  // namespace isotouch::core
