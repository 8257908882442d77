/// A setting of the tick that changes while it runs: an input like any other, so that a recording replays (SPEC.md 5.2).
///
/// tick      yes, every function
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "shared/tick_io.h"

namespace isotouch {

/// Numbers as they stand in a record; 0 = none.
enum class TickSetting : std::uint8_t {
  kNone = 0,
  kStiffness,
  kDamping,
  kForceLimit,
  kFriction,
  kFrictionDamping,
  kHandDamping,
  kPassivity,
  kWeight,
};
inline constexpr std::size_t kTickSettings = 8;

struct SettingChange {
  TickSetting setting = TickSetting::kNone;
  std::int32_t raw = 0;  ///< in the setting's own format

  bool operator==(const SettingChange&) const = default;
};

/// The raw values of all settings that may change, by number - 1.
using RawSettings = std::array<std::int32_t, kTickSettings>;

constexpr RawSettings raw_settings(const TickSettings& s) {
  return {s.stiffness.raw(),        s.damping.raw(),      s.force_limit.raw(), s.friction.raw(),
          s.friction_damping.raw(), s.hand_damping.raw(), s.passivity.raw(),   s.weight.raw()};
}

constexpr void store(const RawSettings& raw, TickSettings& s) {
  s.stiffness = Stiffness::from_raw(raw[0]);
  s.damping = Damping::from_raw(raw[1]);
  s.force_limit = Newton::from_raw(raw[2]);
  s.friction = Ratio::from_raw(raw[3]);
  s.friction_damping = Damping::from_raw(raw[4]);
  s.hand_damping = Damping::from_raw(raw[5]);
  s.passivity = Damping::from_raw(raw[6]);
  s.weight = Newton::from_raw(raw[7]);
}

/// Whether a change is one that a tick may be given: none at all, or a value inside SPEC's range.
constexpr bool is_valid(const SettingChange& change) {
  constexpr RawSettings kLow = {1, 0, 1, 0, 0, 0, 0, (-kMostWeight).raw()};
  constexpr RawSettings kHigh = {Stiffness::of(100).raw(), Damping::of(100).raw(), Newton::of(100).raw(), kMostFriction.raw(),
                                 kMostDamping.raw(),       kMostDamping.raw(),     kMostDamping.raw(),    kMostWeight.raw()};
  const std::size_t number = static_cast<std::size_t>(change.setting);
  if (number == 0) return change.raw == 0;
  return number <= kTickSettings && change.raw >= kLow[number - 1] && change.raw <= kHigh[number - 1];
}

}  // namespace isotouch
