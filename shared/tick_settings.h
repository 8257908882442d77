/// How the field feels: what a person may set for the tick, and a change of it, which is an input of a tick like any other.
///
/// tick      yes, every function
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "shared/settings_table.h"
#include "shared/units.h"

namespace isotouch {

/// Numbers as they stand in a record; 0 = none. The first kLiveSettings may change while the field is felt.
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
  kRampTicks,
  kDeviceDamping,
  kDelayTicks,
};
inline constexpr std::size_t kLiveSettings = 8;
inline constexpr std::size_t kTickSettings = 11;

/// The row of each, by number - 1.
inline constexpr std::array<const SettingRow*, kTickSettings> kTickSettingRows = {
    &rows::kStiffness, &rows::kDamping, &rows::kForceLimit, &rows::kFriction,      &rows::kFrictionDamping, &rows::kHandDamping,
    &rows::kPassivity, &rows::kWeight,  &rows::kRampTicks,  &rows::kDeviceDamping, &rows::kDelayTicks};

constexpr std::size_t index_of(TickSetting setting) { return static_cast<std::size_t>(setting) - 1; }

/// The stored integers of all settings, by number - 1.
using RawSettings = std::array<std::int32_t, kTickSettings>;
/// The same of those that may change.
using LiveRaw = std::array<std::int32_t, kLiveSettings>;

/// Part of a recording's header and so of its chain.
struct TickSettings {
  Stiffness stiffness;  ///< where it is largest; 0 = the field's
  Damping damping;      ///< between proxy and HIP
  Newton force_limit = Newton::of(rows::kForceLimit.standard);
  Ratio friction;            ///< Coulomb's μ between proxy and surface
  Damping friction_damping;  ///< viscous friction of the sliding proxy
  Damping hand_damping;      ///< of the hand's filtered speed, in contact
  Damping passivity;         ///< the most that the passivity controller may add to it
  Newton weight;             ///< of the handle, held up along +y
  std::uint32_t ramp_ticks = static_cast<std::uint32_t>(rows::kRampTicks.standard);
  Damping device_damping;         ///< of the device itself, which the passivity controller counts on
  std::uint32_t delay_ticks = 0;  ///< from a sample to its force being felt; the passivity controller needs it

  bool operator==(const TickSettings&) const = default;

  /// Lists the members in the order of their numbers.
  template <class Settings, class Use>
  static constexpr void fields(Settings& s, Use use) {
    use(s.stiffness), use(s.damping), use(s.force_limit), use(s.friction), use(s.friction_damping), use(s.hand_damping), use(s.passivity),
        use(s.weight), use(s.ramp_ticks), use(s.device_damping), use(s.delay_ticks);
  }
};

namespace tick_settings_detail {
template <class U, int F>
constexpr std::int32_t raw(const Fixed<U, F>& value) {
  return value.raw();
}
constexpr std::int32_t raw(std::uint32_t value) { return static_cast<std::int32_t>(value); }
template <class U, int F>
constexpr void set(Fixed<U, F>& value, std::int32_t raw) {
  value = Fixed<U, F>::from_raw(raw);
}
constexpr void set(std::uint32_t& value, std::int32_t raw) { value = static_cast<std::uint32_t>(raw); }
}  // namespace tick_settings_detail

constexpr RawSettings raw_settings(const TickSettings& settings) {
  RawSettings raw{};
  std::size_t i = 0;
  TickSettings::fields(settings, [&](const auto& value) { raw[i++] = tick_settings_detail::raw(value); });
  return raw;
}

constexpr TickSettings from_raw(const RawSettings& raw) {
  TickSettings settings;
  std::size_t i = 0;
  TickSettings::fields(settings, [&](auto& value) { tick_settings_detail::set(value, raw[i++]); });
  return settings;
}

constexpr LiveRaw live_settings(const TickSettings& settings) {
  const RawSettings raw = raw_settings(settings);
  LiveRaw live{};
  for (std::size_t i = 0; i < kLiveSettings; ++i) live[i] = raw[i];
  return live;
}

/// The settings with those that may change replaced.
constexpr TickSettings with_live(const TickSettings& settings, const LiveRaw& live) {
  RawSettings raw = raw_settings(settings);
  for (std::size_t i = 0; i < kLiveSettings; ++i) raw[i] = live[i];
  return from_raw(raw);
}

namespace tick_settings_detail {
inline constexpr auto kRanges = [] {
  std::array<RawRange, kTickSettings> ranges{};
  for (std::size_t i = 0; i < kTickSettings; ++i) ranges[i] = raw_range(*kTickSettingRows[i]);
  return ranges;
}();
}  // namespace tick_settings_detail

/// Whether every setting lies in the range of its row.
constexpr bool is_valid(const TickSettings& settings) {
  const RawSettings raw = raw_settings(settings);
  bool valid = true;
  for (std::size_t i = 0; i < kTickSettings; ++i) valid = valid && tick_settings_detail::kRanges[i].holds(raw[i]);
  return valid;
}

/// One setting takes another value.
struct SettingChange {
  TickSetting setting = TickSetting::kNone;
  std::int32_t raw = 0;  ///< in the setting's own format

  bool operator==(const SettingChange&) const = default;
};

/// Whether a tick may be given this change: none at all, or one of the first kLiveSettings inside the range of its row. "Unset" is no change.
constexpr bool is_valid(const SettingChange& change) {
  if (change.setting == TickSetting::kNone) return change.raw == 0;
  const std::size_t index = index_of(change.setting);
  if (index >= kLiveSettings) return false;
  const RawRange& range = tick_settings_detail::kRanges[index];
  return change.raw >= range.low && change.raw <= range.high;
}

}  // namespace isotouch
