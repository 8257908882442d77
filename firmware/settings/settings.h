/// What a person may set for the daemon: one TOML file, every setting optional. `table.h` says each one's name, unit, range and default.
#pragma once

#include <array>
#include <map>
#include <optional>
#include <string>

#include "shared/settings_table.h"

namespace isotouch::settings {

/// What was measured on one device: replaces what the geometry set says.
struct Calibration {
  std::array<double, 3> angle_at_zero_deg{};  ///< arm angle at count 0, legs 1 to 3

  bool operator==(const Calibration&) const = default;
};

/// Values as a person writes them; empty ones are the geometry set's or the field's.
struct Settings {
  // [loop]
  double tick_hz = 1e9 / rows::kPeriod.standard;
  int priority = 80;
  int exchange_priority = 75;
  int core = -1;
  int exchange_core = -1;
  std::string latency_file = "/dev/cpu_dma_latency";
  bool lock_memory = true;
  double refresh_ms = 2.5;

  // [device]
  std::string geometry = "libnifalcon";
  std::optional<double> torque_per_word_nmm;
  std::optional<double> gear_ratio;
  std::optional<double> angle_at_zero_deg;
  std::array<double, 3> workspace_origin_mm = {0, 0, 125};
  double play_mm = rows::kPlay.standard;
  double damping_n_s_mm = rows::kAssumedDamping;
  int delay_ticks = rows::kAssumedDelayTicks;
  bool keep_homing_flag = true;
  std::string led_homing = "red";
  std::string led_idle = "blue";
  std::string led_active = "green";

  // [boot]
  std::string firmware;
  bool ignore_echo = false;
  bool always_upload = false;
  int attempts = 3;
  double reply_ms = 5;
  int lost_after = 34;

  // [feel]
  std::optional<double> stiffness;
  double damping = rows::kDamping.standard;
  double force_limit_n = rows::kForceLimit.standard;
  double ramp_ms = 50;
  double friction = rows::kFriction.standard;
  double friction_damping = rows::kFrictionDamping.standard;
  double hand_damping = rows::kHandDamping.standard;
  double passivity_damping = rows::kPassivity.standard;
  double weight_n = rows::kWeight.standard;

  // [limits]
  int word = static_cast<int>(rows::kWordLimit.standard);
  int word_slew = static_cast<int>(rows::kWordSlew.standard);
  double penetration_mm = rows::kPenetration.standard;
  double speed_mm_s = rows::kSpeed.standard;
  double hold_ms = rows::kHoldMs;
  double fault_age_ms = rows::kFaultAge.standard * 1e-6;
  int count_jump = static_cast<int>(rows::kCountJump.standard);
  double ramp_after_rest_ms = rows::kRestRampMs;
  int heat_word = static_cast<int>(rows::kHeatWord.standard);
  double heat_s = rows::kHeatTime.standard * 1e-3;
  double field_mib = rows::kFieldMib;

  // [buttons]
  int button_mask = static_cast<int>(rows::kButtonMask.standard);
  bool hold_to_run = false;

  // [lines]
  bool lines_required = false;
  std::string line_chip;
  int line_stop = -1;
  int line_enable = -1;
  int line_enable_back = -1;
  int line_heartbeat = -1;
  int line_light = -1;
  double line_settle_ms = 50;
  int watchdog_priority = 90;
  int watchdog_core = -1;

  // [files]
  std::string field;
  std::string record;
  std::string control;
  std::string state;
  double before_fault_s = 5;

  // [control]
  std::string control_mode = "0660";
  std::string control_group;
  std::string watch_users, watch_groups;
  std::string operate_users, operate_groups;
  std::string service_users, service_groups;

  // [calibration.SERIAL]
  std::map<std::string, Calibration> calibrations;

  bool operator==(const Settings&) const = default;
};

}  // namespace isotouch::settings
