/// From times, as a person sets them, to counts of ticks, as a device model has them.
#pragma once

#include <algorithm>
#include <cstdint>

#include "shared/device_model.h"
#include "shared/settings_table.h"

namespace isotouch {

/// The fewest ticks that last as long as a time, at least `least`.
///
/// period_ns  was rounded to whole ns, so a tick may last half a ns longer
constexpr std::uint32_t ticks_of_ms(double ms, std::uint32_t period_ns, std::uint32_t least = 1) {
  const double ticks = ms * 1e6 / (period_ns + 0.5);
  const auto whole = static_cast<std::uint32_t>(ticks);
  return std::max(whole < ticks ? whole + 1 : whole, least);
}

/// A device sends a packet late now and then: a single tick without one is no reason to hold.
constexpr std::uint32_t hold_ticks(double ms, std::uint32_t period_ns) { return ticks_of_ms(ms, period_ns, 2); }

/// A published device model at another period: what it counts in ticks lasts as long as before.
inline DeviceModel at_period(DeviceModel model, std::uint32_t period_ns) {
  model.hold_ticks = hold_ticks(rows::kHoldMs, period_ns);
  model.ramp_ticks = ticks_of_ms(rows::kRestRampMs, period_ns);
  return model;
}

}  // namespace isotouch
