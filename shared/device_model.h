/// The device as numbers: geometry, encoders, motors, place and limits of one Falcon. All integers; two published sets to begin with, every
/// number that the sources disagree on is a setting.
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

struct DeviceModel {
  // Of the mechanism's lengths only five are felt.
  Mm arm;         ///< a: upper arm
  Mm rod;         ///< b: parallelogram
  Mm joint;       ///< d + e: what the joints add to the rod in the leg's plane
  Mm radial;      ///< c - r: from the motor axis to the grip's joint, along the leg's azimuth
  Mm tangential;  ///< κ: the same across it
  std::array<DeviceLeg, 3> legs{};

  NewtonMmPerWord word_torque;                            ///< k: arm torque of one motor word
  Vec3<Mm> workspace_origin = {Mm{}, Mm{}, Mm::of(125)};  ///< of the workspace, in the device frame
  std::int32_t word_limit = 4095;                         ///< largest motor word
  std::int32_t word_slew = 1'000'000;                     ///< largest change of a word, per second
  Mm penetration_limit = Mm::of(20);                      ///< between proxy and HIP; beyond it is a fault
  MmPerS speed_limit = MmPerS::of(2000);                  ///< of the HIP; beyond it the supervisor holds
  std::uint32_t hold_ticks = 3;                           ///< ticks without a fresh sample until the supervisor holds
  std::uint32_t fault_age_ns = 100'000'000;               ///< without a fresh sample until the supervisor is in fault
  std::int32_t count_jump = 400;                          ///< change in one tick that no hand makes
  std::uint32_t ramp_ticks = 200;                         ///< from no force to full force after rest
  std::uint8_t homing_flag = kFalconHoming;               ///< what a command carries after homing, too
  std::uint8_t led_homing = kFalconRed;                   ///< shown in boot, homing and fault
  std::uint8_t led_idle = kFalconBlue;                    ///< shown in idle, ready and hold
  std::uint8_t led_active = kFalconGreen;                 ///< shown in active
  std::int32_t heat_word = 2000;   ///< rms of a motor word that the motor stands for ever; with the next one 0: not watched
  std::uint32_t heat_ms = 20'000;  ///< time constant of the motors' warming
  std::uint8_t buttons = 15;       ///< mask: which of the grip's buttons resume from fault, and run
  std::uint8_t hold_to_run = 0;    ///< 1: forces only while one of these is held

  bool operator==(const DeviceModel&) const = default;
};

/// The set of libnifalcon: 35° at count 0, 1e-4 N·m a word.
DeviceModel libnifalcon_model();
/// The set of Martin and Hillier: 40° at count 0, 1.5114e-4 N·m a word.
DeviceModel martin_hillier_model();

inline constexpr std::size_t kDeviceModelBytes = 128;
using DeviceModelBytes = std::array<std::uint8_t, kDeviceModelBytes>;

/// SPEC.md, section 5.1. fails never
DeviceModelBytes encode(const DeviceModel& model);
/// fails     kBadModel: a number outside SPEC's range, a reserved byte that is not zero
Result<DeviceModel> decode_model(const DeviceModelBytes& bytes);
/// The hash that names a model: of its bytes. Never 0 for a model of a device.
std::uint64_t hash(const DeviceModel& model);

}  // namespace isotouch
