#include "firmware/settings/live.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <optional>
#include <variant>
#include <vector>

#include "firmware/settings/apply.h"
#include "firmware/settings/table.h"
#include "shared/files/nearest_name.h"
#include "shared/tick_settings.h"

namespace isotouch::settings {

namespace {

/// N s/mm. Any damping jumps with each count of an encoder, in proportion; measured on 2026-11-29 with a light hand (0.15 kg, 0.1 N/mm) that presses into
/// a box of 0.8 N/mm: from 0.03 on `damping` makes itself jump more, and at 0.1 so does `hand_damping`. This is less than half of that.
constexpr double kQuietDamping = 0.012;

std::optional<double> number_in(std::string_view text) {
  double value = 0;
  const auto [end, failed] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (failed != std::errc{} || end != text.data() + text.size()) return std::nullopt;
  return value;
}

bool store_number(const Setting& setting, double value, Settings& settings) {
  if (const auto* member = std::get_if<double Settings::*>(&setting.member)) {
    settings.*(*member) = value;
    return true;
  }
  if (const auto* member = std::get_if<std::optional<double> Settings::*>(&setting.member)) {
    settings.*(*member) = value;
    return true;
  }
  return false;
}

std::string range(const Setting& setting) {
  char text[96];
  std::snprintf(text, sizeof text, "a number from %.10g to %.10g%s%.*s", setting.low, setting.high, setting.unit.empty() ? "" : " ",
                static_cast<int>(setting.unit.size()), setting.unit.data());
  return text;
}

/// The least that can be set is more than some fields and delays allow; 0 would be no stiffness at all, but "unset".
Stiffness settable(Stiffness most) { return std::max(most, Stiffness::of(rows::kStiffness.low)); }

/// Why a name is none that may change, for people: it is another setting's, or misspelt.
///
/// name      without "feel."
std::string refusal_of_name(std::string_view name) {
  const std::string quoted = std::string("'").append(name).append("'");
  std::vector<std::string> names;
  std::string list;
  for (const Setting& setting : table()) {
    if (name == setting.name || name == std::string(setting.section).append(".").append(setting.name))
      return quoted + " can only be set at the start; write it into the settings file and start the controller again";
    if (setting.live == TickSetting::kNone) continue;
    names.emplace_back(setting.name);
    list.append(list.empty() ? "" : ", ").append(setting.name);
  }
  const std::string meant = files::nearest_name(name, names);
  return "there is no setting " + quoted + "; " +
         (meant.empty() ? "while the controller runs it may be one of " + list : "did you mean '" + meant + "'?");
}

}  // namespace

Settings LiveSettings::now() const {
  const std::lock_guard guard(mutex_);
  return now_;
}

Refusal LiveSettings::set(std::string_view name, std::string_view value, loop::Requests& requests, std::uint32_t measured_delay,
                          const Setter& setter) {
  constexpr std::string_view kSection = "feel.";
  if (name.starts_with(kSection)) name.remove_prefix(kSection.size());
  const Setting* setting = find("feel", name);
  if (setting == nullptr || setting->live == TickSetting::kNone) return refusal_of_name(name);
  const std::optional<double> wanted = number_in(value);
  if (!wanted || !(*wanted >= setting->low && *wanted <= setting->high)) {
    return std::string("feel.").append(name).append(" must be ") + range(*setting);
  }
  const bool has_limit = setting->live != TickSetting::kStiffness || begin_.stiffness || setter.fields > Stiffness{};
  if (!setter.may_raise && !has_limit)
    return "feel.stiffness: the limit for the role operate is the field's own stiffness, and there is no field; load one first";
  const std::optional<double> limit = setter.may_raise ? std::nullopt : limit_of(setting->live, setter.fields);
  if (limit && std::abs(*wanted) > *limit) {
    return std::string("feel.")
        .append(name)
        .append(" may be at most ")
        .append(number(*limit))
        .append(
            " for the role operate, by what the controller was started with, the field or the device; ask somebody with the role service");
  }
  const std::lock_guard guard(mutex_);
  Settings changed = now_;
  store_number(*setting, *wanted, changed);
  if (Refusal refusal = refusal_of_stiffness(changed, measured_delay)) return refusal;
  change_to(changed, requests, setter.author);
  if (setting->live == TickSetting::kStiffness) is_fields_limit_ = limit && !begin_.stiffness;
  return {};
}

/// The largest magnitude of what may add to a force or make it tremble; none: the setting does neither.
std::optional<double> LiveSettings::limit_of(TickSetting setting, Stiffness fields) const {
  switch (setting) {
    case TickSetting::kStiffness: return begin_.stiffness.value_or(std::ldexp(fields.raw(), -rows::kStiffness.fraction_bits));
    case TickSetting::kForceLimit: return begin_.force_limit_n;
    case TickSetting::kWeight: return std::abs(begin_.weight_n);
    case TickSetting::kDamping: return std::max(begin_.damping, kQuietDamping);
    case TickSetting::kFrictionDamping: return std::max(begin_.friction_damping, kQuietDamping);
    case TickSetting::kHandDamping: return std::max(begin_.hand_damping, kQuietDamping);
    case TickSetting::kPassivity: return std::max(begin_.passivity_damping, kQuietDamping);
    default: return std::nullopt;
  }
}

/// What differs goes to the tick. Under the lock.
void LiveSettings::change_to(const Settings& changed, loop::Requests& requests, std::uint32_t author) {
  const LiveRaw before = live_settings(tick_settings(now_)), after = live_settings(tick_settings(changed));
  for (std::size_t i = 0; i < kLiveSettings; ++i) {
    if (after[i] != before[i]) requests.set({static_cast<TickSetting>(i + 1), after[i]}, author);
  }
  now_ = changed;
}

std::string LiveSettings::keep_within(loop::Requests& requests, std::uint32_t measured_delay) {
  const std::lock_guard guard(mutex_);
  const Stiffness most = settable(most_stiffness(now_, measured_delay));
  if (tick_settings(now_).stiffness <= most) return {};
  Settings changed = now_;
  changed.stiffness = *number_in(n_mm(most));
  change_to(changed, requests, kNobody);
  return "feel.stiffness was lowered to " + n_mm(most) +
         " N/mm, the largest that this device can render stably at this rate with the measured delay of " + std::to_string(measured_delay) +
         " ticks";
}

std::string LiveSettings::keep_within_field(loop::Requests& requests, Stiffness fields) {
  const std::lock_guard guard(mutex_);
  const Stiffness most = settable(fields);
  if (!is_fields_limit_ || tick_settings(now_).stiffness <= most) return {};
  Settings changed = now_;
  changed.stiffness = rows::kStiffness.value(most.raw());
  change_to(changed, requests, kNobody);
  return "feel.stiffness fell to the new field's own, the limit for the role operate";
}

}  // namespace isotouch::settings
