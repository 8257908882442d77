/// The whole tick: reply packet → pose → motion → contact → force → supervisor → motor commands. Pure and integer, so that a recorded trace replays to the bit.
#pragma once

#include <cstdint>

#include "firmware/core/kinematics.h"
#include "firmware/core/motion.h"
#include "firmware/core/motor_commands.h"
#include "firmware/core/motor_heat.h"
#include "firmware/core/render.h"
#include "firmware/core/reply_reader.h"
#include "firmware/core/settings_ramp.h"
#include "firmware/core/supervisor.h"
#include "shared/device_model.h"
#include "shared/field_view.h"
#include "shared/tick_io.h"

namespace isotouch::core {

/// What does not change between ticks, prepared once so that the tick needs no division.
struct TickModel {
  DeviceModel device;
  Mechanism mechanism;
  MotionModel motion;
  RenderModel any_field;  ///< what is felt, before a field says its edge and stiffness
  Supervision supervision;
  Motors motors;
  HeatBudget heat;
};

/// device       a valid model (`decode_model` accepts its bytes)
/// settings     as in the trace's header
/// period_ns    the tick period, 100,000 to 4,000,000
/// tick         no: divides
TickModel make_tick_model(const DeviceModel& device, const TickSettings& settings, std::uint32_t period_ns);

/// Everything a tick remembers; a default one is the state before the first tick.
struct TickState {
  SettingsRamp settings;      ///< those that may change
  bool has_settings = false;  ///< false: those of the model hold
  RenderModel felt;           ///< prepared for the field of this generation and these settings
  std::uint32_t field_generation = 0;
  ReplyState reply;
  PoseState pose;
  MotionState motion;
  RenderState render;
  SupervisorMemory supervisor;
  MotorHeat heat;  ///< kept by a restart, see `Input::heat`
  MotorCommands commands{};
};

/// One tick of the device.
///
/// in        the newest packet with its age, and what is asked of the tick. A malformed packet counts as none
/// field     a checked view, or nullptr as long as there is none: then, and only then, `in.field_generation` is 0. Another field comes with another
///           generation: the proxy starts at the HIP and the force rises from zero by a ramp. A patched one comes with another generation and
///           kRequestMoved: it is on the same grid, and what is felt goes on
/// returns   motor commands and flags for the next command packet, and everything that a trace records. Commands are zero in every state but kActive
/// fails     never: the resting output needs no permission
/// tick      yes: constant loop counts, no division, no allocation
Output tick(const Input& in, const FieldView* field, const TickModel& model, TickState& state);

}  // namespace isotouch::core
