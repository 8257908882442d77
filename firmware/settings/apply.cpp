#include "firmware/settings/apply.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "shared/certificate.h"
#include "shared/tick_times.h"

namespace isotouch::settings {

namespace {

template <class T>
T fixed(double value) {
  return T::from_raw(static_cast<std::int32_t>(std::llround(std::ldexp(value, T::kFractionBits))));
}

Angle angle(double degrees) { return Angle::from_raw(static_cast<std::uint32_t>(std::llround(std::ldexp(degrees / 360, 32)))); }

AnglePerCount per_count(double gear_ratio) {
  constexpr double kCountsPerTurn = 1280;
  return AnglePerCount::from_raw(static_cast<std::int32_t>(std::llround(std::ldexp(1 / (kCountsPerTurn * gear_ratio), 40))));
}

std::uint8_t led(const std::string& colour) {
  if (colour == "red") return kFalconRed;
  if (colour == "green") return kFalconGreen;
  if (colour == "blue") return kFalconBlue;
  return 0;
}

std::int64_t ns_of_ms(double ms) { return std::llround(ms * 1e6); }

/// The delay is the longer one of what the settings tell and what was measured.
Loop loop_of(const Settings& settings, std::uint32_t measured_delay) {
  return {period_ns(settings), fixed<Damping>(settings.damping_n_s_mm),
          std::max(static_cast<std::uint32_t>(settings.delay_ticks), measured_delay)};
}

/// What is said of a delay that is longer than the settings know.
std::string and_the_delay(const Settings& settings, std::uint32_t measured_delay) {
  if (measured_delay <= static_cast<std::uint32_t>(settings.delay_ticks)) return {};
  return " and its measured delay of " + std::to_string(measured_delay) + " ticks";
}

DeviceModel geometry_of(const Settings& settings) {
  return settings.geometry == "libnifalcon" ? libnifalcon_model() : martin_hillier_model();
}

}  // namespace

Refusal refusal_of_angles(const Settings& settings) {
  const auto too_far = [](const std::string& setting, double degrees, const std::string& from) {
    char given[32];
    std::snprintf(given, sizeof given, "%g", degrees);
    return setting + " has an arm at " + given + " degrees, more than " + std::to_string(kFarthestTurnDeg) + " degrees away from " + from +
           "; correct it, or leave it out and measure it with isotouch calibrate";
  };
  const DeviceModel geometry = geometry_of(settings);
  for (std::size_t i = 0; i < geometry.legs.size(); ++i) {
    const Angle usual = geometry.legs[i].at_zero;
    if (settings.angle_at_zero_deg && !stands_near(angle(*settings.angle_at_zero_deg), usual))
      return too_far("device.angle_at_zero_deg", *settings.angle_at_zero_deg, "where the geometry has it");
    const Angle expected = settings.angle_at_zero_deg ? angle(*settings.angle_at_zero_deg) : usual;
    for (const auto& [serial, calibration] : settings.calibrations) {
      const double degrees = calibration.angle_at_zero_deg[i];
      if (stands_near(angle(degrees), expected)) continue;
      return too_far("calibration." + serial + ".angle_at_zero_deg", degrees,
                     settings.angle_at_zero_deg ? "device.angle_at_zero_deg" : "where the geometry has it");
    }
  }
  return {};
}

Result<DeviceModel> device_model(const Settings& settings, const std::string& serial) {
  DeviceModel model = geometry_of(settings);
  const auto calibration = settings.calibrations.find(serial);
  for (std::size_t i = 0; i < model.legs.size(); ++i) {
    DeviceLeg& leg = model.legs[i];
    if (settings.gear_ratio) leg.per_count = per_count(*settings.gear_ratio);
    if (settings.angle_at_zero_deg) leg.at_zero = angle(*settings.angle_at_zero_deg);
    if (calibration != settings.calibrations.end()) leg.at_zero = angle(calibration->second.angle_at_zero_deg[i]);
  }
  if (settings.torque_per_word_nmm) model.word_torque = fixed<NewtonMmPerWord>(*settings.torque_per_word_nmm);
  const auto& origin = settings.workspace_origin_mm;
  model.workspace_origin = {fixed<Mm>(origin[0]), fixed<Mm>(origin[1]), fixed<Mm>(origin[2])};
  model.word_limit = settings.word;
  model.word_slew = settings.word_slew;
  model.penetration_limit = fixed<Mm>(settings.penetration_mm);
  model.speed_limit = fixed<MmPerS>(settings.speed_mm_s);
  model.hold_ticks = hold_ticks(settings.hold_ms, period_ns(settings));
  model.fault_age_ns = static_cast<std::uint32_t>(ns_of_ms(settings.fault_age_ms));
  model.count_jump = settings.count_jump;
  model.play = fixed<Mm>(settings.play_mm);
  model.ramp_ticks = ticks_of_ms(settings.ramp_after_rest_ms, period_ns(settings));
  model.homing_flag = settings.keep_homing_flag ? std::uint8_t{kFalconHoming} : std::uint8_t{0};
  model.led_homing = led(settings.led_homing);
  model.led_idle = led(settings.led_idle);
  model.led_active = led(settings.led_active);
  model.heat_word = settings.heat_word;
  model.heat_ms = static_cast<std::uint32_t>(std::llround(settings.heat_s * 1000));
  model.buttons = static_cast<std::uint8_t>(settings.button_mask);
  model.hold_to_run = settings.hold_to_run ? 1 : 0;
  return decode_model(encode(model));
}

TickSettings tick_settings(const Settings& settings) {
  TickSettings tick;
  tick.stiffness = fixed<Stiffness>(settings.stiffness.value_or(0));
  tick.damping = fixed<Damping>(settings.damping);
  tick.force_limit = fixed<Newton>(settings.force_limit_n);
  tick.ramp_ticks = ticks_of_ms(settings.ramp_ms, period_ns(settings));
  tick.friction = fixed<Ratio>(settings.friction);
  tick.friction_damping = fixed<Damping>(settings.friction_damping);
  tick.hand_damping = fixed<Damping>(settings.hand_damping);
  tick.passivity = fixed<Damping>(settings.passivity_damping);
  tick.device_damping = fixed<Damping>(settings.damping_n_s_mm);
  tick.weight = fixed<Newton>(settings.weight_n);
  tick.delay_ticks = static_cast<std::uint32_t>(settings.delay_ticks);
  return tick;
}

std::uint32_t period_ns(const Settings& settings) { return static_cast<std::uint32_t>(std::llround(1e9 / settings.tick_hz)); }

Refusal refusal_of(const FieldView& field, const Settings& settings, std::uint32_t measured_delay) {
  const CertificateCheck check = check_certificate(field, loop_of(settings, measured_delay), tick_settings(settings).stiffness);
  if (check.accepted) return {};
  if (check.error != Error::kTooStiff) return std::string("the field is not usable: ") + describe(check.error) + "; build it again";
  return "the field is too stiff for this device at this rate" + and_the_delay(settings, measured_delay) +
         "; set feel.stiffness to at most " + n_mm(check.stiffness) + " N/mm";
}

Refusal refusal_of_stiffness(const Settings& settings, std::uint32_t measured_delay) {
  const Stiffness most = most_stiffness(settings, measured_delay);
  if (tick_settings(settings).stiffness <= most) return {};
  return "that is too stiff for this device at this rate" + and_the_delay(settings, measured_delay) + "; feel.stiffness may be at most " +
         n_mm(most) + " N/mm";
}

Stiffness most_stiffness(const Settings& settings, std::uint32_t measured_delay) {
  return largest_stiffness(loop_of(settings, measured_delay));
}

std::string n_mm(Stiffness stiffness) {
  char text[32];
  std::snprintf(text, sizeof text, "%.9g", std::floor((stiffness.raw() + 0.49) / 65.536) / 1000);  // what is rounded to no more than this
  return text;
}

falcon::SessionSettings session_settings(const Settings& settings) {
  falcon::SessionSettings session;
  session.boot.attempts = settings.attempts;
  session.boot.ignore_echo = settings.ignore_echo;
  session.boot.always_upload = settings.always_upload;
  const std::int64_t hold_ns = std::int64_t{hold_ticks(settings.hold_ms, period_ns(settings))} * period_ns(settings);
  session.device.reply_ns = std::min(ns_of_ms(settings.reply_ms), hold_ns);  // the next packet carries no force
  session.device.lost_after = settings.lost_after;
  return session;
}

Threads thread_rights(const Settings& settings) {
  return {{settings.priority, settings.core},
          {settings.exchange_priority, settings.exchange_core},
          {settings.watchdog_priority, settings.watchdog_core}};
}

lines::GpioSettings gpio_settings(const Settings& settings) {
  return {settings.line_stop, settings.line_enable, settings.line_enable_back, settings.line_heartbeat, settings.line_light};
}

loop::WatchdogSettings watchdog_settings(const Settings& settings) {
  loop::WatchdogSettings watchdog;
  watchdog.settle_ns = ns_of_ms(settings.line_settle_ms);
  return watchdog;
}

std::size_t field_bytes(const Settings& settings) { return static_cast<std::size_t>(std::llround(settings.field_mib * 1024 * 1024)); }

}  // namespace isotouch::settings
