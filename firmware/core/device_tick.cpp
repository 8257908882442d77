#include "firmware/core/device_tick.h"

#include <algorithm>

#include "firmware/core/handle_weight.h"
#include "firmware/core/joint_angles.h"
#include "firmware/core/joint_torques.h"
#include "firmware/core/longer.h"

namespace isotouch::core {

namespace {

constexpr std::uint32_t when(bool condition, StatusBits bit) { return condition ? std::uint32_t{bit} : 0U; }

/// Takes over the settings that hold now. Those that never changed stay as they were prepared, to the bit.
void take_over(const SettingsRamp& ramp, TickModel& felt) {
  TickSettings settings = felt.settings;
  store(ramp.now, settings);
  if (!(settings == felt.settings)) retune(settings, felt);
}

/// Another field: nothing that was felt before holds. The proxy begins at the HIP.
void take_field(const BlobView* field, std::uint32_t generation, const DeviceTickModel& model, DeviceState& state) {
  state.field_generation = generation;
  state.tick = {};
  finish_settings(state.settings);
  state.felt = model.any_field;
  take_over(state.settings, state.felt);
  if (field != nullptr) state.felt = for_field(state.felt, *field);
}

/// What a person has set anew since the last tick.
void take_settings(const SettingChange& change, const DeviceTickModel& model, DeviceState& state) {
  if (!state.has_settings) {
    begin_settings(model.any_field.settings, state.settings);
    state.felt = model.any_field;
    state.has_settings = true;
  }
  const bool felt = state.supervisor.state == SupervisorState::kActive;
  if (advance_settings(change, !felt, state.felt.coupling, state.settings)) take_over(state.settings, state.felt);
}

/// The colours tell people what to expect; homing stays asked for, see the model.
std::uint8_t packet_flags(SupervisorState state, const DeviceModel& device) {
  const bool looking = state == SupervisorState::kBoot || state == SupervisorState::kHoming;
  const bool red = looking || state == SupervisorState::kFault;
  const std::uint8_t led = red ? device.led_homing : state == SupervisorState::kActive ? device.led_active : device.led_idle;
  return static_cast<std::uint8_t>(led | (looking ? std::uint8_t{kFalconHoming} : device.homing_flag));
}

}  // namespace

DeviceTickModel make_device_model(const DeviceModel& device, const TickSettings& settings, std::uint32_t period_ns) {
  DeviceTickModel model;
  model.device = device;
  model.mechanism = make_mechanism(device);
  model.motors = make_motors(device, period_ns);
  model.heat = make_heat_budget(device, period_ns);
  model.largest_move = make_largest_move(device, period_ns);
  model.supervision = make_supervision(device, period_ns);
  model.rate = PerSecond::from_raw(static_cast<std::int32_t>(1'000'000'000LL * (1 << PerSecond::kFractionBits) / period_ns));
  model.any_field = make_model(settings, period_ns);
  return model;
}

DeviceOutput device_tick(const DeviceInput& in, const BlobView* field, const DeviceTickModel& model, DeviceState& state) {
  if ((in.commands & kCommandRestart) != 0) state = {};
  take_settings(in.change, model, state);
  const Reading reading = read_reply(in, model.device, state.reply);
  const bool new_field = in.field_generation != state.field_generation;
  if (new_field) take_field(field, in.field_generation, model, state);

  DeviceOutput out;
  out.buttons = state.reply.buttons;
  if (reading.jumped || !state.reply.homed) {
    state.pose = {};
    state.velocity = {};
    state.move = {};
    state.tick = {};
  }
  const Pose pose = state.reply.homed ? follow_pose(joint_angles(state.reply.counts, model.device), model.mechanism, state.pose) : Pose{};
  if (pose.settled) {
    out.hip = pose.hip - model.device.workspace_origin;
    const Vec3<MmPerS> velocity = hip_velocity(out.hip, reading.fresh, model.rate, state.velocity);
    const bool leapt = is_leap(out.hip, reading.fresh, model.largest_move, state.move);
    out.tick.status |= when(leapt || is_longer(velocity, model.device.speed_limit), kTooFast);
  }
  out.tick.proxy = out.hip;
  const std::uint16_t age = static_cast<std::uint16_t>(std::min<std::uint32_t>(state.reply.stale, 65535));
  if (pose.settled && field != nullptr) {
    const std::uint32_t so_far = out.tick.status;
    out.tick = tick({out.hip, out.buttons, reading.fresh, age}, *field, state.felt, state.tick);
    out.tick.status |= so_far;
  }

  Observations seen;
  seen.heard = state.reply.heard;
  seen.homed = state.reply.homed;
  seen.jumped = reading.jumped;
  seen.pose_settled = pose.settled;
  seen.has_field = field != nullptr;
  seen.new_field = new_field;
  seen.too_deep = (out.tick.status & kContact) != 0 && is_longer(out.tick.proxy - out.hip, model.device.penetration_limit);
  seen.too_fast = (out.tick.status & kTooFast) != 0;
  seen.stale_ticks = state.reply.stale;
  seen.late = in.late;
  seen.lines = in.lines;
  seen.buttons = state.reply.buttons;
  seen.commands = in.commands;
  const Permission permission = supervise(seen, model.supervision, state.supervisor);

  out.tick.force = with_handle_held_up(out.tick.force, state.felt.settings.weight);
  if (!permission.granted || permission.ramping) forget(state.tick.passivity);  // the hand does not feel what the ledger would book

  MotorWords words;
  out.tick.force = permission.granted ? mul<Newton>(out.tick.force, permission.part) : Vec3<Newton>{};
  const WordLimit limit = word_limit(model.motors, model.heat, state.heat);
  if (permission.granted) words = motor_words(joint_torques(out.tick.force, pose.statics), limit.motors, state.words);
  if (!allows_words(state.supervisor.state)) words = {};  // the last gate: whatever was computed
  state.words = out.tick.words = words.words;
  warm(words.words, model.heat, state.heat);

  out.tick.state = static_cast<std::uint16_t>(state.supervisor.state);
  out.tick.status |= when(!reading.fresh, kStale) | when(reading.malformed, kBadReply) | when(reading.jumped, kCountJump) |
                     when(state.reply.homed && !pose.settled, kPoseUncertain) |
                     when(pose.settled && pose.statics.near_singular, kNearSingular) | when(permission.ramping, kRamping) |
                     when(words.limited, kWordsLimited) | when(words.slew_limited, kSlewLimited) | when(limit.lowered, kHeatLimited) |
                     when(in.late > 0, kLate);
  out.faults = state.supervisor.faults;
  out.packet_flags = packet_flags(state.supervisor.state, model.device);
  return out;
}

}  // namespace isotouch::core
