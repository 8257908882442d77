#include "firmware/settings/table.h"

#include <cstdio>

#include "shared/hash64.h"
#include "shared/printable.h"

namespace isotouch::settings {

std::string number(double value, const char* format) {
  char text[32];
  std::snprintf(text, sizeof text, format, value);
  return text;
}

namespace {

using S = Settings;
constexpr std::string_view kLeds = "none|red|green|blue";

/// A setting that is a row of the shared table, in the same unit.
constexpr Setting of(std::string_view section, const SettingRow& row, const Member& member, std::string_view otherwise = {},
                     TickSetting live = TickSetting::kNone) {
  return {section, row.name, member, row.unit, row.low, row.high, {}, row.meaning, otherwise, live};
}

/// One that a person writes in another unit than the tick counts in.
///
/// factor    from the row's unit to this one
constexpr Setting of(std::string_view section, const SettingRow& row, std::string_view name, std::string_view unit, double factor,
                     const Member& member, std::string_view meaning) {
  return {section, name, member, unit, row.low * factor, row.high * factor, {}, meaning, {}};
}

constexpr Setting feel(TickSetting setting, const Member& member, std::string_view otherwise = {}) {
  return of("feel", *kTickSettingRows[index_of(setting)], member, otherwise, setting);
}

/// Names or numbers, separated by commas.
constexpr Setting role(std::string_view name, const Member& member, std::string_view meaning) {
  return {"control", name, member, {}, 0, 0, {}, meaning, {}};
}

constexpr double kMinTickHz = 1e9 / rows::kPeriod.high, kMaxTickHz = 1e9 / rows::kPeriod.low;
/// Of a number of ticks at the highest rate: that many ticks fit the row at every rate.
constexpr double kMsPerTick = 1000 / kMaxTickHz;

constexpr Setting kTable[] = {
    {"loop", "tick_hz", &S::tick_hz, "Hz", kMinTickHz, kMaxTickHz, {}, "ticks a second", {}},
    {"loop", "priority", &S::priority, {}, 0, 99, {}, "SCHED_FIFO priority of the tick's thread; 0 = the ordinary scheduler", {}},
    {"loop",
     "exchange_priority",
     &S::exchange_priority,
     {},
     0,
     99,
     {},
     "SCHED_FIFO priority of the thread that talks to the device; below the tick's",
     {}},
    {"loop", "core", &S::core, {}, -1, 1023, {}, "processor core of the tick's thread, best an isolated one; -1 = any", {}},
    {"loop", "exchange_core", &S::exchange_core, {}, -1, 1023, {}, "processor core of the thread that talks to the device; -1 = any", {}},
    {"loop",
     "latency_file",
     &S::latency_file,
     {},
     0,
     0,
     {},
     "the kernel's file that keeps processors out of idle states while force is possible; empty = they may sleep",
     {}},
    {"loop", "lock_memory", &S::lock_memory, {}, 0, 0, {}, "keep all memory of the program in RAM", {}},
    {"loop", "refresh_ms", &S::refresh_ms, "ms", 0.5, 20, {}, "longest time between two packets to the device, even if no tick comes", {}},

    {"device", "geometry", &S::geometry, {}, 0, 0, "libnifalcon|martin-hillier", "published set of lengths, ratios and torques", {}},
    of("device", rows::kWordTorque, &S::torque_per_word_nmm, "0.1 or 0.15114, by geometry"),
    {"device",
     "gear_ratio",
     &S::gear_ratio,
     {},
     1,
     100,
     {},
     "turns of a motor for one turn of its arm; a turn is 1280 counts",
     "7.7193 or 7.62, by geometry"},
    {"device", "angle_at_zero_deg", &S::angle_at_zero_deg, "degrees", -180, 180, {}, "angle of an arm at count 0", "35 or 40, by geometry"},
    {"device",
     "workspace_origin_mm",
     &S::workspace_origin_mm,
     rows::kWorkspaceOrigin.unit,
     rows::kWorkspaceOrigin.low,
     rows::kWorkspaceOrigin.high,
     {},
     "middle of the workspace: x right, y up, z towards the person, from the middle of the motor axes",
     {}},
    of("device", rows::kPlay, &S::play_mm),
    of("device", rows::kDeviceDamping, &S::damping_n_s_mm),
    of("device", rows::kDelayTicks, &S::delay_ticks),
    {"device", "keep_homing_flag", &S::keep_homing_flag, {}, 0, 0, {}, "true: packets also carry the homing flag after homing", {}},
    {"device", "led_homing", &S::led_homing, {}, 0, 0, kLeds, "light until homed, and in fault", {}},
    {"device", "led_idle", &S::led_idle, {}, 0, 0, kLeds, "light while there is no force", {}},
    {"device", "led_active", &S::led_active, {}, 0, 0, kLeds, "light while there may be force", {}},

    {"boot",
     "firmware",
     &S::firmware,
     {},
     0,
     0,
     {},
     "file with the device's firmware; \"\" = only a device whose firmware already runs is accepted",
     {}},
    {"boot", "ignore_echo", &S::ignore_echo, {}, 0, 0, {}, "true: go on if an echo of the upload differs", {}},
    {"boot", "always_upload", &S::always_upload, {}, 0, 0, {}, "true: upload even if firmware already runs", {}},
    {"boot", "attempts", &S::attempts, {}, 1, 100, {}, "uploads that may fail before the boot counts as failed", {}},
    {"boot", "reply_ms", &S::reply_ms, "ms", 1, 100, {}, "how long to wait for a reply; never longer than limits.hold_ms", {}},
    {"boot",
     "lost_after",
     &S::lost_after,
     {},
     1,
     1000,
     {},
     "packets in a row without a reply until the controller looks for the device again",
     {}},

    feel(TickSetting::kStiffness, &S::stiffness, "the field's"),
    feel(TickSetting::kDamping, &S::damping),
    feel(TickSetting::kForceLimit, &S::force_limit_n),
    of("feel", rows::kRampTicks, "ramp_ms", "ms", kMsPerTick, &S::ramp_ms,
       "time from no force to full force if contact did not begin at rest; a change of a setting takes as long"),
    feel(TickSetting::kFriction, &S::friction),
    feel(TickSetting::kFrictionDamping, &S::friction_damping),
    feel(TickSetting::kHandDamping, &S::hand_damping),
    feel(TickSetting::kPassivity, &S::passivity_damping),
    feel(TickSetting::kWeight, &S::weight_n),

    of("limits", rows::kWordLimit, &S::word),
    of("limits", rows::kWordSlew, &S::word_slew),
    of("limits", rows::kPenetration, &S::penetration_mm),
    of("limits", rows::kSpeed, &S::speed_mm_s),
    of("limits", rows::kHoldTicks, "hold_ms", "ms", kMsPerTick, &S::hold_ms,
       "time without a fresh packet, or of missed ticks, until the force stops; at least two ticks"),
    of("limits", rows::kFaultAge, "fault_age_ms", "ms", 1e-6, &S::fault_age_ms, rows::kFaultAge.meaning),
    of("limits", rows::kCountJump, &S::count_jump),
    of("limits", rows::kRestRampTicks, "ramp_after_rest_ms", "ms", kMsPerTick, &S::ramp_after_rest_ms,
       "time from no force to full force after the force was stopped"),
    of("limits", rows::kHeatWord, &S::heat_word),
    of("limits", rows::kHeatTime, "heat_s", "s", 1e-3, &S::heat_s, rows::kHeatTime.meaning),
    {"limits",
     "field_mib",
     &S::field_mib,
     "MiB",
     1,
     1024,
     {},
     "largest unpacked field; the program takes four times as much memory at its start",
     {}},

    of("buttons", rows::kButtonMask, &S::button_mask),
    {"buttons", "hold_to_run", &S::hold_to_run, {}, 0, 0, {}, rows::kHoldToRun.meaning, {}},

    {"lines",
     "required",
     &S::lines_required,
     {},
     0,
     0,
     {},
     "true: the controller does not start without a chip, an emergency stop, a heartbeat, and the motors' enable with its return line",
     {}},
    {"lines", "chip", &S::line_chip, {}, 0, 0, {}, "GPIO chip of the safety lines, such as \"gpiochip0\"; \"\" = there are none", {}},
    {"lines", "stop", &S::line_stop, {}, -1, 1023, {}, "input, emergency stop: high = run, low = pressed or broken wire; -1 = none", {}},
    {"lines", "enable", &S::line_enable, {}, -1, 1023, {}, "output, power of the motors: high = on; -1 = none", {}},
    {"lines", "enable_back", &S::line_enable_back, {}, -1, 1023, {}, "input, reads the relay of enable back; -1 = none", {}},
    {"lines", "heartbeat", &S::line_heartbeat, {}, -1, 1023, {}, "output for a watchdog relay, changes every millisecond; -1 = none", {}},
    {"lines", "light", &S::line_light, {}, -1, 1023, {}, "output, light: on while there may be force, blinks in fault; -1 = none", {}},
    {"lines", "settle_ms", &S::line_settle_ms, "ms", 1, 1000, {}, "how long enable_back may differ from enable", {}},
    {"lines", "priority", &S::watchdog_priority, {}, 0, 99, {}, "SCHED_FIFO priority of the watchdog's thread; above the tick's", {}},
    {"lines", "core", &S::watchdog_core, {}, -1, 1023, {}, "processor core of the watchdog's thread; -1 = any", {}},

    {"files", "field", &S::field, {}, 0, 0, {}, "field to begin with; \"\" = none", {}},
    {"files", "record", &S::record, {}, 0, 0, {}, "recordings from the first tick on, numbered: a-1.trace of \"a.trace\"; \"\" = none", {}},
    {"files", "control", &S::control, {}, 0, 0, {}, "path of the control socket; \"\" = none", {}},
    {"files", "state", &S::state, {}, 0, 0, {}, "folder for fields, calibrations and faults; \"\" = nothing is kept", {}},
    {"files", "before_fault_s", &S::before_fault_s, "s", 0.1, 60, {}, "seconds before a fault that are saved to the state folder", {}},

    {"control", "mode", &S::control_mode, {}, 0, 0, {}, "permissions of the control socket's file, octal", {}},
    {"control", "group", &S::control_group, {}, 0, 0, {}, "group of the socket's file; \"\" = the program's", {}},
    role("watch_users", &S::watch_users, "users who may watch and stop"),
    role("watch_groups", &S::watch_groups, "groups whose members may do so"),
    role("operate_users", &S::operate_users,
         "users who may also send and choose fields, record, resume, and change settings within the limits"),
    role("operate_groups", &S::operate_groups, "groups whose members may do so"),
    role("service_users", &S::service_users,
         "users who may also raise limits, calibrate, and resume after a fault of lines, memory or guard; root and the program's own user "
         "may"),
    role("service_groups", &S::service_groups, "groups whose members may do so"),
};

const Settings kDefaults;

/// The value of a member, as it would stand in the file; empty: an optional one that is left out.
std::string shown(const Member& member, const Settings& settings, const char* format = "%.10g") {
  struct Show {
    const Settings& all;
    const char* format;
    std::string operator()(double S::*m) const { return number(all.*m, format); }
    std::string operator()(int S::*m) const { return std::to_string(all.*m); }
    std::string operator()(bool S::*m) const { return all.*m ? "true" : "false"; }
    std::string operator()(std::string S::*m) const { return std::string("\"").append(all.*m).append("\""); }
    std::string operator()(std::optional<double> S::*m) const { return all.*m ? number(*(all.*m), format) : std::string(); }
    std::string operator()(std::array<double, 3> S::*m) const {
      const auto& v = all.*m;
      return std::string("[")
          .append(number(v[0], format))
          .append(", ")
          .append(number(v[1], format))
          .append(", ")
          .append(number(v[2], format))
          .append("]");
    }
  };
  return std::visit(Show{settings, format}, member);
}

std::string line(std::string_view section, std::string_view name, const std::string& value) {
  return std::string(section).append(".").append(name).append(" = ").append(value).append("\n");
}

std::string calibrations(const Settings& settings, const char* format) {
  std::string text;
  for (const auto& [serial, calibration] : settings.calibrations) {
    Settings place;
    place.workspace_origin_mm = calibration.angle_at_zero_deg;
    std::string section = "calibration." + serial;
    make_printable(section, '?');
    text += line(section, "angle_at_zero_deg", shown(&S::workspace_origin_mm, place, format));
  }
  return text;
}

}  // namespace

std::span<const Setting> table() { return kTable; }

const Setting* find(std::string_view section, std::string_view name) {
  for (const Setting& setting : kTable) {
    if (setting.section == section && setting.name == name) return &setting;
  }
  return nullptr;
}

std::string different(const Settings& settings) {
  std::string text;
  for (const Setting& setting : kTable) {
    std::string value = shown(setting.member, settings);
    if (value == shown(setting.member, kDefaults)) continue;
    make_printable(value, '?');
    text += line(setting.section, setting.name, value.empty() ? "left out" : value);
  }
  return text + calibrations(settings, "%.10g");
}

std::uint64_t checksum(const Settings& settings) {
  constexpr const char* kExact = "%.17g";
  std::string text;
  Settings relevant = settings;
  relevant.record.clear();
  for (const Setting& setting : kTable) text += line(setting.section, setting.name, shown(setting.member, relevant, kExact));
  text += calibrations(settings, kExact);
  return hash64(reinterpret_cast<const std::uint8_t*>(text.data()), text.size());
}

std::string default_file() {
  std::string text = "# Every setting with its default. A file needs only the settings that differ.\n";
  std::string_view section;
  for (const Setting& setting : kTable) {
    if (setting.section != section) text.append("\n[").append(section = setting.section).append("]\n");
    text.append("# ").append(setting.meaning);
    if (setting.live != TickSetting::kNone) text.append(" (may change while running)");
    if (!setting.choices.empty()) text.append(": ").append(setting.choices);
    if (setting.low != setting.high) text.append("; ").append(number(setting.low)).append(" to ").append(number(setting.high));
    if (!setting.unit.empty()) text.append(" ").append(setting.unit);
    text.append("\n");
    if (setting.otherwise.empty()) {
      text.append(setting.name).append(" = ").append(shown(setting.member, kDefaults)).append("\n");
    } else {
      text.append("# ").append(setting.name).append(" =    (").append(setting.otherwise).append(")\n");
    }
  }
  text.append("\n# Measured on one device, named by its serial:\n# [calibration.ABCD1234]\n");
  text.append("# angle of each arm at count 0: top, right, left; -180 to 180 degrees\n# angle_at_zero_deg = [35, 35, 35]\n");
  return text;
}

}  // namespace isotouch::settings
