#include "firmware/core/settings_ramp.h"

#include <cstddef>

namespace isotouch::core {

namespace {

/// Every setting sets out from where it is. None is far below 0, so a difference fits 32 bits; the ramp's part is at most 2^30.
void set_out(const Coupling& coupling, SettingsRamp& ramp) {
  for (std::size_t i = 0; i < kLiveSettings; ++i) {
    const std::int32_t way = saturated_difference(ramp.target[i], ramp.now[i]);
    ramp.step[i] = static_cast<std::int32_t>(round_shift(product(way, coupling.ramp_part.raw()), RampPart::kFractionBits));
  }
  ramp.left = coupling.ramp_ticks;
}

}  // namespace

void begin_settings(const TickSettings& settings, SettingsRamp& ramp) {
  ramp.target = live_settings(settings);
  finish_settings(ramp);
}

void finish_settings(SettingsRamp& ramp) {
  ramp.now = ramp.target;
  ramp.left = 0;
}

bool advance_settings(const SettingChange& change, bool at_once, const Coupling& coupling, SettingsRamp& ramp) {
  const bool changes = change.setting != TickSetting::kNone && is_valid(change);
  if (changes) {
    std::int32_t& stiffness = ramp.now[index_of(TickSetting::kStiffness)];
    if (change.setting == TickSetting::kStiffness && stiffness == 0) stiffness = coupling.stiffness.raw();
    ramp.target[index_of(change.setting)] = change.raw;
    set_out(coupling, ramp);
  }
  if (!changes && ramp.left == 0) return false;
  if (at_once || ramp.left <= 1) {
    finish_settings(ramp);
    return true;
  }
  --ramp.left;
  for (std::size_t i = 0; i < kLiveSettings; ++i) ramp.now[i] += ramp.step[i];
  return true;
}

}  // namespace isotouch::core
