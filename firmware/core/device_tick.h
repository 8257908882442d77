/// The whole tick of a device, wire to wire: reply packet → counts → angles → HIP → proxy → force → torques → motor words, and the supervisor's
/// word on them. Pure and integer like `tick`, which it contains.
#pragma once

#include <cstdint>

#include "firmware/core/hip_velocity.h"
#include "firmware/core/kinematics.h"
#include "firmware/core/motor_heat.h"
#include "firmware/core/motor_words.h"
#include "firmware/core/move_check.h"
#include "firmware/core/reply_reader.h"
#include "firmware/core/settings_ramp.h"
#include "firmware/core/supervisor.h"
#include "firmware/core/tick.h"
#include "shared/blob.h"
#include "shared/device_io.h"
#include "shared/device_model.h"

namespace isotouch::core {

/// What does not change between ticks, prepared once so that the tick needs no division.
struct DeviceTickModel {
  DeviceModel device;
  Mechanism mechanism;
  Motors motors;
  HeatBudget heat;
  Mm largest_move;  ///< of the HIP in a tick, at twice the speed limit
  Supervision supervision;
  PerSecond rate;       ///< ticks a second
  TickModel any_field;  ///< what is felt, before a field says its edge and stiffness
};

/// device       a valid model (`decode_model` accepts its bytes)
/// settings     as in the trace's header
/// period_ns    the tick period, 100,000 to 4,000,000
/// tick         no: divides
DeviceTickModel make_device_model(const DeviceModel& device, const TickSettings& settings, std::uint32_t period_ns);

/// Everything a tick remembers; a default one is the state before the first tick.
struct DeviceState {
  ReplyState reply;
  PoseState pose;
  VelocityState velocity;
  SettingsRamp settings;      ///< those that may change
  bool has_settings = false;  ///< false: those of the model hold
  TickModel felt;             ///< prepared for the field of this generation and these settings
  TickState tick;
  std::uint32_t field_generation = 0;
  MoveState move;
  MotorHeat heat;
  SupervisorMemory supervisor;
  std::array<std::int16_t, 3> words{};
};

/// One tick of the device.
///
/// in        the newest packet with its age, and what is asked of the tick. A malformed packet counts as none
/// field     a checked view, or nullptr as long as there is none: then, and only then, `in.field_generation` is 0. Another field comes with another
///           generation: the proxy starts at the HIP and the force rises from zero by a ramp
/// returns   motor words and flags for the next command packet, and everything that a trace records. Words are zero in every state but kActive
/// fails     never: the resting output needs no permission
/// tick      yes: constant loop counts, no division, no allocation
DeviceOutput device_tick(const DeviceInput& in, const BlobView* field, const DeviceTickModel& model, DeviceState& state);

}  // namespace isotouch::core
