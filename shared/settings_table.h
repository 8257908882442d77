/// The one table of the numbers that decide how the device and the field behave: name, unit, number format, range, default and meaning.
///
/// The settings file, `isotouchd --print-config`, `isotouch set`, the tool's options, the recording's header and a change in a record take name and
/// range from here; a test holds the tables of SPEC.md against it. To add a setting, add a row here, and use it where it takes effect.
#pragma once

#include <cstdint>
#include <string_view>

namespace isotouch {

struct SettingRow {
  std::string_view name;  ///< in the settings file where a person sets it there in this unit, and in SPEC.md
  std::string_view unit;  ///< empty: a plain number
  int fraction_bits = 0;  ///< of the stored integer
  double low = 0;         ///< in the unit; the range holds both ends
  double high = 0;
  double standard = 0;  ///< the default
  std::string_view meaning;
  bool zero_means_unset = false;  ///< 0 is valid although it lies outside the range: nothing was set

  /// A value of this row as the integer that is stored, nearest.
  constexpr std::int32_t raw(double value) const {
    const double scaled = value * static_cast<double>(std::int64_t{1} << fraction_bits);
    return static_cast<std::int32_t>(scaled < 0 ? scaled - 0.5 : scaled + 0.5);
  }
  /// The value of such an integer, exact.
  constexpr double value(std::int32_t stored) const {
    return static_cast<double>(stored) / static_cast<double>(std::int64_t{1} << fraction_bits);
  }
};

/// The part of a row that runs: integers alone, made at compile time.
struct RawRange {
  std::int32_t low = 0, high = 0;
  bool zero_means_unset = false;

  constexpr bool holds(std::int64_t raw) const { return (raw >= low && raw <= high) || (zero_means_unset && raw == 0); }
};

constexpr RawRange raw_range(const SettingRow& row) { return {row.raw(row.low), row.raw(row.high), row.zero_means_unset}; }

namespace rows {

/// The tick's period; the settings file states its inverse, `loop.tick_hz`.
inline constexpr SettingRow kPeriod{"period", "ns", 0, 100'000, 4'000'000, 1'000'000, "time from one tick to the next"};

/// Memory that a controller keeps for a field unless it is set up for more (`[field] field_mib`), MiB.
inline constexpr double kFieldMib = 16;

// How the field feels. The first eight may change while it is felt.
inline constexpr SettingRow kStiffness{"stiffness", "N/mm", 16, 0.001, 100, 0, "largest stiffness of the surface; unset = the field's own",
                                       true};
inline constexpr SettingRow kDamping{"damping", "N s/mm", 24, 0, 0.1, 0, "damping between proxy and hand"};
inline constexpr SettingRow kForceLimit{
    "force_limit_n", "N", 16, 0, 50, 8, "largest force of the object; the force that holds the handle's weight is added to it"};
inline constexpr SettingRow kFriction{"friction", "", 30, 0, 1.5, 0, "Coulomb friction between hand and surface"};
inline constexpr SettingRow kFrictionDamping{"friction_damping", "N s/mm", 24, 0, 0.1, 0, "viscous friction of a hand that slides"};
inline constexpr SettingRow kHandDamping{"hand_damping", "N s/mm", 24, 0, 0.1, 0, "damping of a hand in contact, in every direction"};
inline constexpr SettingRow kPassivity{"passivity_damping",
                                       "N s/mm",
                                       24,
                                       0,
                                       0.1,
                                       0,
                                       "largest damping that the passivity controller may add against trembling; 0 = off, 0.012 works"};
inline constexpr SettingRow kWeight{
    "weight_n", "N", 16, -5, 5, 0, "weight of the handle that the motors hold up; a Falcon's is 0.75 to 0.85 N"};
inline constexpr SettingRow kRampTicks{
    "ramp_ticks", "ticks", 0, 0, 100'000, 50, "ticks from no force to full force if contact did not begin at rest"};
inline constexpr SettingRow kDeviceDamping{
    "damping_n_s_mm", "N s/mm", 24, 0.0001, 0.1, 0, "damping of the device itself at the grip; it limits how stiff a field may be", true};
inline constexpr SettingRow kDelayTicks{"delay_ticks", "ticks", 0, 0, 7, 0, "ticks from a reply of the device to the force made of it"};

// What is taken for the two above where nobody measured them: by a field that advises a stiffness, and by a controller's settings. A trace begins with 0.
inline constexpr double kAssumedDamping = 0.003;  ///< N s/mm; the Falcon's own is about that
inline constexpr int kAssumedDelayTicks = 1;

// The device.
inline constexpr SettingRow kArm{"arm", "mm", 20, 20, 120, 60, "upper arm a"};
inline constexpr SettingRow kRod{"rod", "mm", 20, 50, 150, 102.5, "parallelogram b"};
inline constexpr SettingRow kJoint{"joint", "mm", 20, 0, 50, 22.5, "joints d + e"};
inline constexpr SettingRow kRadial{"radial", "mm", 20, -60, 60, -25.57, "radial c - r"};
inline constexpr SettingRow kTangential{"tangential", "mm", 20, -30, 30, -1.91, "tangential κ"};
inline constexpr SettingRow kWordTorque{
    "torque_per_word_nmm", "N mm", 24, 0.01, 1, 0.1, "torque at the arm of one unit of a motor command"};
inline constexpr SettingRow kWorkspaceOrigin{"workspace_origin_mm", "mm", 20, -300, 300, 0, "origin of the workspace in the device frame"};
inline constexpr SettingRow kWordLimit{"word", "", 0, 0, 4095, 4095, "largest motor command"};
inline constexpr SettingRow kWordSlew{
    "word_slew", "1/s", 0, 1'000, 100'000'000, 1'000'000, "largest change of a motor command in a second; at least one unit a tick"};
inline constexpr SettingRow kPenetration{"penetration_mm", "mm", 20, 0.1, 200, 20, "a hand deeper in the object than this causes a fault"};
inline constexpr SettingRow kSpeed{"speed_mm_s", "mm/s", 12, 1, 100'000, 2000, "a hand faster than this gets no force"};
inline constexpr SettingRow kHoldTicks{
    "hold_ticks", "ticks", 0, 1, 1000, 3, "ticks without a fresh packet, or missed ticks, until the force stops"};
inline constexpr SettingRow kFaultAge{
    "fault_age", "ns", 0, 1'000'000, 1'000'000'000, 100'000'000, "how long a hold may last, or packets be missing, before it is a fault"};
inline constexpr SettingRow kCountJump{
    "count_jump", "counts", 0, 10, 4000, 400, "largest change of an encoder in one tick that a hand can make"};
inline constexpr SettingRow kRestRampTicks{
    "rest_ramp_ticks", "ticks", 0, 1, 100'000, 200, "ticks from no force to full force after the force was stopped"};
inline constexpr SettingRow kPlay{
    "play_mm", "mm", 20, 0, 1, 0.046, "movement of the hand in one encoder count; a smaller movement counts as rest"};
inline constexpr SettingRow kFlags{"flags", "", 0, 0, 15, 0, "flags of a command packet"};
inline constexpr SettingRow kHeatWord{
    "heat_word", "", 0, 1, 4095, 2000, "root mean square of a command that a motor can bear without end; our own estimate", true};
inline constexpr SettingRow kHeatTime{
    "heat_time", "ms", 0, 1'000, 1'000'000, 20'000, "time constant with which the motors warm; our own estimate", true};
inline constexpr SettingRow kButtonMask{
    "mask", "", 0, 0, 15, 15, "buttons of the grip that resume from a fault, and that hold_to_run needs: the sum of 1, 2, 4, 8"};
inline constexpr SettingRow kHoldToRun{"hold_to_run", "", 0, 0, 1, 0, "true: there is force only while one of these buttons is held"};

// Standards in ticks are ticks of the standard period; at any other period these times hold.
inline constexpr double kHoldMs = kHoldTicks.standard * kPeriod.standard * 1e-6;
inline constexpr double kRestRampMs = kRestRampTicks.standard * kPeriod.standard * 1e-6;

}  // namespace rows

}  // namespace isotouch
