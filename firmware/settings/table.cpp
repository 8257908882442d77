#include "firmware/settings/table.h"

#include <cstdio>

namespace isotouch::settings {

namespace {

using S = Settings;
constexpr std::string_view kLeds = "none|red|green|blue";

constexpr Setting kTable[] = {
    {"loop", "tick_hz", &S::tick_hz, "Hz", 250, 10'000, {}, "ticks a second", {}},
    {"loop", "priority", &S::priority, {}, 0, 99, {}, "of the tick's thread, SCHED_FIFO; 0 = the ordinary scheduler", {}},
    {"loop",
     "exchange_priority",
     &S::exchange_priority,
     {},
     0,
     99,
     {},
     "of the thread that talks to the device, best below the tick's",
     {}},
    {"loop", "core", &S::core, {}, -1, 1023, {}, "processor core of the tick's thread, best one that is isolated; -1 = any", {}},
    {"loop", "lock_memory", &S::lock_memory, {}, 0, 0, {}, "keep all memory of the program in RAM", {}},
    {"loop",
     "refresh_ms",
     &S::refresh_ms,
     "ms",
     0.5,
     20,
     {},
     "longest time between two packets to the device, also when no tick comes",
     {}},

    {"device", "geometry", &S::geometry, {}, 0, 0, "libnifalcon|martin-hillier", "published set of lengths, ratios and torques", {}},
    {"device",
     "torque_per_word_nmm",
     &S::torque_per_word_nmm,
     "N mm",
     0.01,
     1,
     {},
     "torque at the arm of one unit of a motor word",
     "0.1 or 0.15114, by geometry"},
    {"device",
     "gear_ratio",
     &S::gear_ratio,
     {},
     1,
     100,
     {},
     "turns of a motor, of 1280 counts, for one of its arm",
     "7.7193 or 7.62, by geometry"},
    {"device", "angle_at_zero_deg", &S::angle_at_zero_deg, "degrees", -180, 180, {}, "angle of an arm at count 0", "35 or 40, by geometry"},
    {"device",
     "workspace_origin_mm",
     &S::workspace_origin_mm,
     "mm",
     -300,
     300,
     {},
     "middle of the workspace: x right, y up, z towards the person, from the middle of the motor axes",
     {}},
    {"device",
     "damping_n_s_mm",
     &S::damping_n_s_mm,
     "N s/mm",
     0.0001,
     0.1,
     {},
     "of the device itself, at the grip; with the next one it limits how stiff a field may be",
     {}},
    {"device", "delay_ticks", &S::delay_ticks, "ticks", 0, 10, {}, "from a reply to the words made of it being felt", {}},
    {"device", "keep_homing_flag", &S::keep_homing_flag, {}, 0, 0, {}, "packets carry the homing flag after homing, too", {}},
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
     "file with the device's firmware; \"\" = only a device whose firmware runs is taken",
     {}},
    {"boot", "ignore_echo", &S::ignore_echo, {}, 0, 0, {}, "go on though an echo of the upload differs", {}},
    {"boot", "always_upload", &S::always_upload, {}, 0, 0, {}, "upload also when firmware runs already", {}},
    {"boot", "attempts", &S::attempts, {}, 1, 100, {}, "uploads until a boot counts as failed", {}},
    {"boot", "reply_ms", &S::reply_ms, "ms", 1, 100, {}, "how long a reply is waited for", {}},
    {"boot", "lost_after", &S::lost_after, {}, 1, 1000, {}, "packets in a row without reply until the device is looked for again", {}},

    {"feel", "stiffness", &S::stiffness, "N/mm", 0.001, 10, {}, "of the surface", "the blob's", true},
    {"feel", "damping", &S::damping, "N s/mm", 0, 0.1, {}, "between hand and surface", {}, true},
    {"feel", "force_limit_n", &S::force_limit_n, "N", 0, 50, {}, "largest force of the object; the handle's weight comes on top", {}, true},
    {"feel",
     "ramp_ms",
     &S::ramp_ms,
     "ms",
     1,
     10'000,
     {},
     "from no force to full force where contact did not begin at rest; of settings that change",
     {}},
    {"feel", "friction", &S::friction, {}, 0, 1.5, {}, "between hand and surface, Coulomb's coefficient", {}, true},
    {"feel", "friction_damping", &S::friction_damping, "N s/mm", 0, 0.1, {}, "viscous friction of a hand that slides", {}, true},
    {"feel", "hand_damping", &S::hand_damping, "N s/mm", 0, 0.1, {}, "of a hand that touches, in every direction", {}, true},
    {"feel",
     "passivity_damping",
     &S::passivity_damping,
     "N s/mm",
     0,
     0.1,
     {},
     "most that the passivity controller may add where delay would make the hand tremble; 0 = off, 0.012 does",
     {},
     true},
    {"feel", "weight_n", &S::weight_n, "N", -5, 5, {}, "of the handle, held up; a Falcon's is 0.75 to 0.85", {}, true},

    {"limits", "word", &S::word, {}, 0, 4095, {}, "largest motor word", {}},
    {"limits",
     "word_slew",
     &S::word_slew,
     "1/s",
     1'000,
     100'000'000,
     {},
     "largest change of a motor word; a whole unit a tick at least",
     {}},
    {"limits", "penetration_mm", &S::penetration_mm, "mm", 0.1, 200, {}, "a hand deeper than that is a fault", {}},
    {"limits", "speed_mm_s", &S::speed_mm_s, "mm/s", 1, 100'000, {}, "of the hand; beyond it forces rest", {}},
    {"limits", "hold_ms", &S::hold_ms, "ms", 0.5, 100, {}, "without a fresh sample until forces rest; two ticks at least", {}},
    {"limits", "fault_age_ms", &S::fault_age_ms, "ms", 1, 1000, {}, "without a fresh sample until that is a fault", {}},
    {"limits", "count_jump", &S::count_jump, "counts", 10, 4000, {}, "change of an encoder in one tick that no hand makes", {}},
    {"limits", "ramp_after_rest_ms", &S::ramp_after_rest_ms, "ms", 1, 10'000, {}, "from no force to full force after a rest", {}},
    {"limits", "heat_word", &S::heat_word, {}, 1, 4095, {}, "rms of a motor word that a motor stands for ever; own guess", {}},
    {"limits", "heat_s", &S::heat_s, "s", 1, 1000, {}, "time constant of the motors' warming; own guess", {}},
    {"limits",
     "field_mib",
     &S::field_mib,
     "MiB",
     1,
     1024,
     {},
     "largest unpacked field; four times as much memory is taken at the start",
     {}},

    {"buttons", "mask", &S::button_mask, {}, 0, 15, {}, "which buttons of the grip resume from a fault, and run: bits 1, 2, 4, 8", {}},
    {"buttons", "hold_to_run", &S::hold_to_run, {}, 0, 0, {}, "forces only while one of these buttons is held", {}},

    {"lines", "chip", &S::line_chip, {}, 0, 0, {}, "GPIO chip of the safety lines, such as \"gpiochip0\"; \"\" = there are none", {}},
    {"lines", "stop", &S::line_stop, {}, -1, 1023, {}, "emergency stop, in: high = run, low = pressed or broken; -1 = none", {}},
    {"lines", "enable", &S::line_enable, {}, -1, 1023, {}, "power of the motors, out: high = on; -1 = none", {}},
    {"lines", "enable_back", &S::line_enable_back, {}, -1, 1023, {}, "its relay read back, in; -1 = none", {}},
    {"lines", "heartbeat", &S::line_heartbeat, {}, -1, 1023, {}, "changes every millisecond for a watchdog relay, out; -1 = none", {}},
    {"lines", "light", &S::line_light, {}, -1, 1023, {}, "light, out: on with forces, blinks in fault; -1 = none", {}},
    {"lines", "settle_ms", &S::line_settle_ms, "ms", 1, 1000, {}, "how long the enable may read back otherwise than it was set", {}},
    {"lines", "priority", &S::watch_priority, {}, 0, 99, {}, "of the thread that watches lines and tick, SCHED_FIFO", {}},

    {"files", "field", &S::field, {}, 0, 0, {}, "blob to begin with; \"\" = none", {}},
    {"files", "record", &S::record, {}, 0, 0, {}, "file for a recording from the first tick on; \"\" = none", {}},
    {"files", "control", &S::control, {}, 0, 0, {}, "path of the control socket; \"\" = none", {}},
    {"files", "state", &S::state, {}, 0, 0, {}, "folder for what is kept; \"\" = nothing is kept", {}},
    {"files",
     "before_fault_s",
     &S::before_fault_s,
     "s",
     0.1,
     60,
     {},
     "so much of the past is saved to the state folder when a fault comes",
     {}},

    {"control", "mode", &S::control_mode, {}, 0, 0, {}, "permissions of the control socket's file, octal", {}},
    {"control", "group", &S::control_group, {}, 0, 0, {}, "group of the socket's file; \"\" = the program's", {}},
    {"control",
     "users",
     &S::control_users,
     {},
     0,
     0,
     {},
     "who may use it beside root and the program's user: names or numbers, with commas",
     {}},
    {"control", "groups", &S::control_groups, {}, 0, 0, {}, "whose members may use it", {}},
};

std::string number(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.10g", value);
  return text;
}

std::string shown(const Member& member) {
  static const Settings kDefaults;
  struct Show {
    std::string operator()(double S::*m) const { return number(kDefaults.*m); }
    std::string operator()(int S::*m) const { return std::to_string(kDefaults.*m); }
    std::string operator()(bool S::*m) const { return kDefaults.*m ? "true" : "false"; }
    std::string operator()(std::string S::*m) const { return std::string("\"").append(kDefaults.*m).append("\""); }
    std::string operator()(std::optional<double> S::*) const { return {}; }
    std::string operator()(std::array<double, 3> S::*m) const {
      const auto& v = kDefaults.*m;
      return std::string("[").append(number(v[0])).append(", ").append(number(v[1])).append(", ").append(number(v[2])).append("]");
    }
  };
  return std::visit(Show{}, member);
}

}  // namespace

std::span<const Setting> table() { return kTable; }

const Setting* find(std::string_view section, std::string_view name) {
  for (const Setting& setting : kTable) {
    if (setting.section == section && setting.name == name) return &setting;
  }
  return nullptr;
}

std::string default_file() {
  std::string text = "# Every setting with its default. All are optional; a file may hold just what differs.\n";
  std::string_view section;
  for (const Setting& setting : kTable) {
    if (setting.section != section) text.append("\n[").append(section = setting.section).append("]\n");
    text.append("# ").append(setting.meaning);
    if (setting.live) text.append(" (may change while running)");
    if (!setting.choices.empty()) text.append(": ").append(setting.choices);
    if (setting.low != setting.high) text.append("; ").append(number(setting.low)).append(" to ").append(number(setting.high));
    if (!setting.unit.empty()) text.append(" ").append(setting.unit);
    text.append("\n");
    if (setting.otherwise.empty()) {
      text.append(setting.name).append(" = ").append(shown(setting.member)).append("\n");
    } else {
      text.append("# ").append(setting.name).append(" =    (").append(setting.otherwise).append(")\n");
    }
  }
  text.append("\n# Measured on one device, named by its serial:\n# [calibration.ABCD1234]\n");
  text.append("# angle of each arm at count 0: top, right, left; -180 to 180 degrees\n# angle_at_zero_deg = [35, 35, 35]\n");
  return text;
}

}  // namespace isotouch::settings
