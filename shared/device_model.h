/// The device as numbers: geometry, encoders, motors, place and limits of one Falcon. All integers. Two published sets are there to begin with; each
/// number that the sources disagree on is a setting. `settings_table.h` has the range of each.
///
/// Legs 1, 2, 3 are top, right, left. Device frame: x right, y up, z towards the person, origin in the plane of the motor axes.
///
/// source    R. E. Stamper, A three degree of freedom parallel manipulator with only translational degrees of freedom, 1997, chapter 3;
///           S. Martin and N. Hillier, Characterisation of the Novint Falcon haptic device for application as a robot manipulator, 2009
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "shared/angle.h"
#include "shared/falcon_packet.h"
#include "shared/result.h"
#include "shared/settings_table.h"
#include "shared/units.h"
#include "shared/vec3.h"

namespace isotouch {

/// One leg: where it stands around the axis, and how its encoder reads the arm's angle.
struct DeviceLeg {
  Angle azimuth;            ///< from x, towards y
  AnglePerCount per_count;  ///< arm angle of one count
  Angle at_zero;            ///< arm angle at count 0; rises when the arm swings outwards

  bool operator==(const DeviceLeg&) const = default;
};

/// How far a calibration may take an arm from where it was expected: public sources differ by 15 degrees.
inline constexpr int kFarthestTurnDeg = 20;

/// Whether an arm's angle at count 0 is within kFarthestTurnDeg of what was expected, the shorter way round.
constexpr bool stands_near(Angle angle, Angle expected) {
  const std::uint32_t turn = (angle - expected).raw(), most = Angle::degrees(kFarthestTurnDeg).raw();
  return turn + most <= 2 * most;
}

consteval std::int32_t standard(const SettingRow& row) { return row.raw(row.standard); }

struct DeviceModel {
  // Of the mechanism's lengths only five are felt.
  Mm arm;         ///< a: upper arm
  Mm rod;         ///< b: parallelogram
  Mm joint;       ///< d + e: what the joints add to the rod in the leg's plane
  Mm radial;      ///< c - r: from the motor axis to the grip's joint, along the leg's azimuth
  Mm tangential;  ///< κ: the same across it
  std::array<DeviceLeg, 3> legs{};

  NewtonMmPerWord word_torque;                                 ///< k: arm torque of one unit of a motor command
  Vec3<Mm> workspace_origin = {Mm{}, Mm{}, Mm::of(125)};       ///< of the workspace, in the device frame
  std::int32_t word_limit = standard(rows::kWordLimit);        ///< largest motor command
  std::int32_t word_slew = standard(rows::kWordSlew);          ///< largest change of a motor command, per second
  Mm penetration_limit = Mm::of(rows::kPenetration.standard);  ///< between proxy and HIP; beyond it is a fault
  MmPerS speed_limit = MmPerS::of(rows::kSpeed.standard);      ///< of the HIP; beyond it the supervisor holds
  std::uint32_t hold_ticks =
      static_cast<std::uint32_t>(standard(rows::kHoldTicks));  ///< ticks without a fresh sample until the supervisor holds
  std::uint32_t fault_age_ns =
      static_cast<std::uint32_t>(standard(rows::kFaultAge));  ///< without a fresh sample until the supervisor is in fault
  std::int32_t count_jump = standard(rows::kCountJump);       ///< change in one tick that no hand makes
  std::uint32_t ramp_ticks = static_cast<std::uint32_t>(standard(rows::kRestRampTicks));  ///< from no force to full force after rest
  Mm play = Mm::of(rows::kPlay.standard);    ///< way of the HIP of the largest encoder count within 50 mm of the workspace's middle
  std::uint8_t homing_flag = kFalconHoming;  ///< what a command carries after homing, too
  std::uint8_t led_homing = kFalconRed;      ///< shown in boot, homing and fault
  std::uint8_t led_idle = kFalconBlue;       ///< shown in idle, ready and hold
  std::uint8_t led_active = kFalconGreen;    ///< shown in active
  std::int32_t heat_word =
      standard(rows::kHeatWord);  ///< rms of a motor command that the motor stands for ever; 0 together with the next: not watched
  std::uint32_t heat_ms = static_cast<std::uint32_t>(standard(rows::kHeatTime));  ///< time constant of the motors' warming
  std::uint8_t buttons =
      static_cast<std::uint8_t>(standard(rows::kButtonMask));  ///< mask: which of the grip's buttons resume from fault, and run
  std::uint8_t hold_to_run = 0;                                ///< 1: forces only while one of these is held

  bool operator==(const DeviceModel&) const = default;
};

/// Walks over the numbers in the order of SPEC.md, each with its row of `settings_table.h`; nullptr: any value of its format is valid.
///
/// use       called as use(const SettingRow*, number)
template <class Model, class Use>
constexpr void for_each_number(Model& m, Use use) {
  use(&rows::kArm, m.arm), use(&rows::kRod, m.rod), use(&rows::kJoint, m.joint), use(&rows::kRadial, m.radial);
  use(&rows::kTangential, m.tangential);
  for (auto& leg : m.legs) use(nullptr, leg.azimuth), use(nullptr, leg.per_count), use(nullptr, leg.at_zero);
  use(&rows::kWordTorque, m.word_torque);
  for (auto* axis : {&m.workspace_origin.x, &m.workspace_origin.y, &m.workspace_origin.z}) use(&rows::kWorkspaceOrigin, *axis);
  use(&rows::kWordLimit, m.word_limit), use(&rows::kWordSlew, m.word_slew);
  use(&rows::kPenetration, m.penetration_limit), use(&rows::kSpeed, m.speed_limit);
  use(&rows::kHoldTicks, m.hold_ticks), use(&rows::kFaultAge, m.fault_age_ns), use(&rows::kCountJump, m.count_jump);
  use(&rows::kRestRampTicks, m.ramp_ticks), use(&rows::kPlay, m.play);
  for (auto* flags : {&m.homing_flag, &m.led_homing, &m.led_idle, &m.led_active}) use(&rows::kFlags, *flags);
  use(&rows::kHeatWord, m.heat_word), use(&rows::kHeatTime, m.heat_ms);
  use(&rows::kButtonMask, m.buttons), use(&rows::kHoldToRun, m.hold_to_run);
}

/// The set of libnifalcon: 35° at count 0, 1e-4 N·m a unit of a motor command.
DeviceModel libnifalcon_model();
/// The set of Martin and Hillier: 40° at count 0, 1.5114e-4 N·m a unit of a motor command.
DeviceModel martin_hillier_model();

inline constexpr std::size_t kDeviceModelBytes = 128;
using DeviceModelBytes = std::array<std::uint8_t, kDeviceModelBytes>;

/// SPEC.md, section 5. fails never
DeviceModelBytes encode(const DeviceModel& model);
/// fails     kBadModel: a number outside SPEC's range, a reserved byte that is not zero
Result<DeviceModel> decode_model(const DeviceModelBytes& bytes);
/// The hash that names a model: of its bytes. Never 0 for a model of a device.
std::uint64_t hash(const DeviceModel& model);

}  // namespace isotouch
