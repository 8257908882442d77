#include "firmware/core/tick.h"

#include "firmware/core/handle_weight.h"
#include "firmware/core/joint_angles.h"
#include "firmware/core/joint_torques.h"
#include "firmware/core/longer.h"

namespace isotouch::core {

namespace {

constexpr std::uint32_t when(bool condition, StatusBits bit) { return condition ? std::uint32_t{bit} : 0U; }

/// Takes over the settings that hold now. Those that never changed stay as they were prepared, to the bit.
void take_over(const SettingsRamp& ramp, RenderModel& felt) {
  const TickSettings settings = with_live(felt.settings, ramp.now);
  if (!(settings == felt.settings)) retune(settings, felt);
}

/// What a person has set anew since the last tick.
void take_settings(const SettingChange& change, const TickModel& model, TickState& state) {
  if (!state.has_settings) {
    begin_settings(model.any_field.settings, state.settings);
    state.felt = model.any_field;
    state.has_settings = true;
  }
  const bool felt = state.supervisor.state.is(SupervisorState::kActive);
  if (advance_settings(change, !felt, state.felt.coupling, state.settings)) take_over(state.settings, state.felt);
}

/// Another field: nothing that was felt before holds, and the proxy begins at the HIP. The same one, patched, goes on being felt.
///
/// returns   whether there is another
bool take_field(const FieldView* field, const Input& in, const TickModel& model, TickState& state) {
  if (in.field_generation == state.field_generation) return false;
  const bool had_one = state.field_generation != 0;
  state.field_generation = in.field_generation;
  if ((in.requests & kRequestMoved) != 0 && had_one && field != nullptr && field->method == Method::kDefault) {
    move_surface(*field, state.felt, state.render);
    return false;
  }
  state.render = {};
  forget_quiet(state.motion);
  finish_settings(state.settings);
  state.felt = model.any_field;
  take_over(state.settings, state.felt);
  if (field != nullptr) state.felt = for_field(state.felt, *field);
  return true;
}

/// Counts that took another reference make void what was computed from the old ones.
Pose find_pose(const Reading& reading, const TickModel& model, TickState& state) {
  if (reading.jumped || !state.reply.homed) {
    state.pose = {};
    state.motion = {};
    state.render = {};
  }
  return state.reply.homed ? follow_pose(joint_angles(state.reply.counts, model.device), model.mechanism, state.pose) : Pose{};
}

Motion find_motion(const Pose& pose, bool fresh, const TickModel& model, TickState& state) {
  if (!pose.settled) return {};
  return track_motion(within(pose.hip - model.device.workspace_origin, kReach), fresh, state.felt.damps(), model.motion, state.motion);
}

Rendering render_contact(const Pose& pose, const Motion& motion, const FieldView* field, TickState& state) {
  if (pose.settled && field != nullptr) return render(motion, *field, state.felt, state.render);
  Rendering nothing;
  nothing.proxy = motion.hip;
  return nothing;
}

bool is_too_fast(const Motion& motion, const TickModel& model) {
  return motion.leapt || is_longer(motion.velocity, model.device.speed_limit);
}

/// A hand deeper than the device's limit; on a surface that has moved by itself, as deep as it feels.
bool is_too_deep(const Rendering& felt, const Motion& motion, const TickModel& model, const TickState& state) {
  if (!felt.touching) return false;
  const Mm limit = model.device.penetration_limit;
  if ((felt.status & kLagging) == 0) return is_longer(felt.proxy - motion.hip, limit);
  const Stiffness stiffness = part_of(state.felt.coupling.stiffness, state.render.spring.felt.part);
  return is_longer(state.render.coupling.lag.felt, mul<Newton>(limit, stiffness));
}

/// What the supervisor judges by.
Observations observe(const Input& in, const Reading& reading, const Pose& pose, const Motion& motion, const Rendering& felt, bool has_field,
                     bool new_field, const TickModel& model, const TickState& state) {
  Observations seen;
  seen.heard = state.reply.heard;
  seen.homed = state.reply.homed;
  seen.jumped = reading.jumped;
  seen.pose_settled = pose.settled;
  seen.has_field = has_field;
  seen.new_field = new_field;
  seen.too_deep = is_too_deep(felt, motion, model, state);
  seen.too_fast = is_too_fast(motion, model);
  seen.stale_ticks = state.reply.stale;
  seen.late = in.late;
  seen.lines = in.lines;
  seen.buttons = state.reply.buttons;
  seen.requests = in.requests;
  return seen;
}

/// What the motors are told, and which force that stands for.
struct Drive {
  Vec3<Newton> force;
  Commanded motors;
  bool heat_limited = false;
};

/// Without permission the motors rest.
Drive drive_motors(const Rendering& felt, const Permission& permission, const Pose& pose, const TickModel& model, TickState& state) {
  Drive drive;
  const CommandLimit limit = command_limit(model.motors, model.heat, state.heat);
  drive.heat_limited = limit.lowered;
  if (permission.granted) {
    drive.force = mul<Newton>(with_handle_held_up(felt.force, state.felt.settings.weight), permission.part);
    drive.motors = motor_commands(joint_torques(drive.force, pose.statics), limit.motors, state.commands);
  }
  state.commands = drive.motors.commands;
  warm(state.commands, model.heat, state.heat);
  return drive;
}

/// The colours tell people what to expect; homing stays asked for, see the model.
std::uint8_t packet_flags(SupervisorState state, const DeviceModel& device) {
  const bool looking = state == SupervisorState::kBoot || state == SupervisorState::kHoming;
  const bool red = looking || state == SupervisorState::kFault;
  const std::uint8_t led = red ? device.led_homing : state == SupervisorState::kActive ? device.led_active : device.led_idle;
  return static_cast<std::uint8_t>(led | (looking ? std::uint8_t{kFalconHoming} : device.homing_flag));
}

}  // namespace

TickModel make_tick_model(const DeviceModel& device, const TickSettings& settings, std::uint32_t period_ns) {
  TickModel model;
  model.device = device;
  model.mechanism = make_mechanism(device);
  model.motion = make_motion_model(device, period_ns);
  model.any_field = make_render_model(settings, model.motion.rate);
  model.supervision = make_supervision(device, period_ns);
  model.motors = make_motors(device, period_ns);
  model.heat = make_heat_budget(device, period_ns);
  return model;
}

Output tick(const Input& in, const FieldView* field, const TickModel& model, TickState& state) {
  if ((in.requests & kRequestRestart) != 0) {
    state = {};
    state.heat = heat_from(in.change.setting == TickSetting::kNone ? in.heat : 0);
  }
  take_settings(in.change, model, state);
  const bool new_field = take_field(field, in, model, state);

  const Reading reading = read_reply(in, model.device, state.reply);
  const Pose pose = find_pose(reading, model, state);
  const Motion motion = find_motion(pose, reading.fresh, model, state);
  const Rendering felt = render_contact(pose, motion, field, state);
  const Observations seen = observe(in, reading, pose, motion, felt, field != nullptr, new_field, model, state);
  const Permission permission = supervise(seen, model.supervision, state.supervisor);
  if (!permission.granted || permission.ramping) forget(state.render.passivity);  // the hand does not feel what the ledger would book
  const Drive drive = drive_motors(felt, permission, pose, model, state);

  Output out;
  out.hip = motion.hip;
  out.proxy = felt.proxy;
  out.force = drive.force;
  out.commands = drive.motors.commands;
  const SupervisorState now = state.supervisor.state;
  out.state = static_cast<std::uint16_t>(now);
  out.status = felt.status | when(!reading.fresh, kStale) | when(reading.malformed, kBadReply) | when(reading.jumped, kCountJump) |
               when(state.reply.homed && !pose.settled, kPoseUncertain) | when(seen.too_fast, kTooFast) |
               when(pose.settled && pose.statics.near_singular, kNearSingular) | when(permission.ramping, kRamping) |
               when(drive.motors.limited, kCommandsLimited) | when(drive.motors.slew_limited, kSlewLimited) |
               when(drive.heat_limited, kHeatLimited) | when(in.late > 0, kLate);
  out.faults = state.supervisor.faults;
  out.packet_flags = packet_flags(now, model.device);
  out.buttons = state.reply.buttons;
  return out;
}

}  // namespace isotouch::core
