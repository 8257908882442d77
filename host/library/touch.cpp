/// A hand on a field: each tick is a step of `trace::Run`, which also replays recordings.
#include <cmath>
#include <cstdint>
#include <memory>
#include <optional>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "host/library/call.h"
#include "host/library/felt.h"
#include "host/library/field.h"
#include "host/library/handles.h"
#include "host/library/settings.h"
#include "host/to_double.h"
#include "host/trace/replay.h"
#include "host/trace/trace_file.h"
#include "shared/certificate.h"
#include "shared/falcon_packet.h"
#include "shared/files/state_text.h"

using namespace isotouch;
using namespace isotouch::library;

// What the header promises is what a tick says.
static_assert(std::uint32_t{ISOTOUCH_STATUS_CONTACT} == kContact);
static_assert(std::uint32_t{ISOTOUCH_STATUS_FOLLOWING} == kFollowing);
static_assert(std::uint32_t{ISOTOUCH_STATUS_OUTSIDE_GRID} == kOutsideGrid);
static_assert(std::uint32_t{ISOTOUCH_STATUS_HELD_INSIDE} == kHeldInside);
static_assert(std::uint32_t{ISOTOUCH_STATUS_RAMPING} == kRamping);
static_assert(std::uint32_t{ISOTOUCH_STATUS_FORCE_LIMITED} == kForceLimited);
static_assert(std::uint32_t{ISOTOUCH_STATUS_STALE} == kStale);
static_assert(std::uint32_t{ISOTOUCH_STATUS_INPUT_CLAMPED} == kInputClamped);
static_assert(std::uint32_t{ISOTOUCH_STATUS_BAD_REPLY} == kBadReply);
static_assert(std::uint32_t{ISOTOUCH_STATUS_COUNT_JUMP} == kCountJump);
static_assert(std::uint32_t{ISOTOUCH_STATUS_POSE_UNCERTAIN} == kPoseUncertain);
static_assert(std::uint32_t{ISOTOUCH_STATUS_NEAR_SINGULAR} == kNearSingular);
static_assert(std::uint32_t{ISOTOUCH_STATUS_TOO_FAST} == kTooFast);
static_assert(std::uint32_t{ISOTOUCH_STATUS_COMMANDS_LIMITED} == kCommandsLimited);
static_assert(std::uint32_t{ISOTOUCH_STATUS_SLEW_LIMITED} == kSlewLimited);
static_assert(std::uint32_t{ISOTOUCH_STATUS_HEAT_LIMITED} == kHeatLimited);
static_assert(std::uint32_t{ISOTOUCH_STATUS_LATE} == kLate);
static_assert(std::uint32_t{ISOTOUCH_STATUS_DAMPED} == kDamped);
static_assert(std::uint32_t{ISOTOUCH_STATUS_LAGGING} == kLagging);
static_assert(std::uint32_t{ISOTOUCH_FAULT_STOPPED} == kFaultStopped);
static_assert(std::uint32_t{ISOTOUCH_FAULT_SILENT} == kFaultSilent);
static_assert(std::uint32_t{ISOTOUCH_FAULT_PENETRATION} == kFaultPenetration);
static_assert(std::uint32_t{ISOTOUCH_FAULT_ENCODERS} == kFaultEncoders);
static_assert(std::uint32_t{ISOTOUCH_FAULT_POSE} == kFaultPose);
static_assert(std::uint32_t{ISOTOUCH_FAULT_SPEED} == kFaultSpeed);
static_assert(std::uint32_t{ISOTOUCH_FAULT_LATE} == kFaultLate);
static_assert(std::uint32_t{ISOTOUCH_FAULT_EMERGENCY} == kFaultEmergency);
static_assert(std::uint32_t{ISOTOUCH_FAULT_ENABLE} == kFaultEnable);
static_assert(std::uint32_t{ISOTOUCH_FAULT_MEMORY} == kFaultMemory);
static_assert(std::uint32_t{ISOTOUCH_FAULT_GUARD} == kFaultGuard);

namespace {

constexpr std::uint64_t kMaxKept = 10'000'000;
constexpr std::uint32_t kButtons = 15, kHomed = 7;

struct TouchThing final : Thing {
  TouchThing(std::shared_ptr<const field_file::OpenField> on, const TraceHeader& header, std::size_t record_ticks)
      : Thing(Kind::kTouch),
        field(std::move(on)),
        run(field->view, header),
        kept(record_ticks) {}  // filled: no page of it is new in a tick

  std::shared_ptr<const field_file::OpenField> field;
  trace::Run run;
  std::vector<TraceRecord> kept;
  std::uint64_t ticks = 0;
  std::optional<Input> last;  ///< without requests
  std::uint8_t requests = 0;  ///< of the next tick

  std::uint64_t recorded() const { return std::min<std::uint64_t>(ticks, kept.size()); }
};

/// The next tick. Of all inputs only the sample is another one.
isotouch_felt step(TouchThing& touch, Input input) {
  touch.last = input;
  const std::uint8_t requests = std::exchange(touch.requests, std::uint8_t{0});
  if (input.kind == InputKind::kPacket) input.requests = requests;
  TraceRecord record = touch.run.step(input);
  record.arrival_ns = touch.ticks * touch.run.header().period_ns;
  if (touch.ticks < touch.kept.size()) touch.kept[static_cast<std::size_t>(touch.ticks)] = record;
  return felt_of(touch.ticks++, record.output);
}

/// fails     CallError: the touch has begun with inputs of the other kind
void require_kind(const TouchThing& touch, InputKind kind) {
  if (!touch.last || touch.last->kind == kind) return;
  refuse(ISOTOUCH_BAD_ARGUMENT, kind == InputKind::kPosition ? "this touch has begun with encoder counts; make another one for positions"
                                                             : "this touch has begun with positions; make another one for encoder counts");
}

void require_bits(std::uint32_t bits, std::uint32_t known, const char* name) {
  if ((bits & ~known) == 0) return;
  refuse(ISOTOUCH_BAD_ARGUMENT, std::string(name) + " is " + std::to_string(bits) + ", but only the bits of " + std::to_string(known) +
                                    " have a meaning; clear the others");
}

Input position_of(const double* hip_mm, std::uint32_t buttons) {
  Input input = position_input(to_fixed<Mm>(Eigen::Vector3d(hip_mm[0], hip_mm[1], hip_mm[2])));
  input.buttons = static_cast<std::uint8_t>(buttons);
  return input;
}

Input packet_of(const std::int32_t* counts, std::uint32_t homed, std::uint32_t buttons) {
  FalconReply reply;
  for (std::size_t leg = 0; leg < reply.counts.size(); ++leg) {
    if (counts[leg] != static_cast<std::int16_t>(counts[leg]))
      refuse(ISOTOUCH_BAD_ARGUMENT, "count " + std::to_string(leg) + " (from 0) is " + std::to_string(counts[leg]) +
                                        ", beyond the 16 bits of the device; pass the device's own counts");
    reply.counts[leg] = static_cast<std::int16_t>(counts[leg]);
  }
  reply.buttons = static_cast<std::uint8_t>(buttons);
  reply.homed = static_cast<std::uint8_t>(homed);
  Input input;
  input.kind = InputKind::kPacket;
  input.fresh = true;
  input.field_generation = 1;
  input.packet = encode(reply);
  return input;
}

/// As a controller at its door. Without a known damping of the device no stiffness can be too large.
///
/// fails     InputError: what to set instead
void require_stable(const FieldView& field, const TraceHeader& header) {
  const TickSettings& settings = header.settings;
  if (settings.device_damping <= Damping{}) return;
  const CertificateCheck check =
      check_certificate_header(field, {header.period_ns, settings.device_damping, settings.delay_ticks}, settings.stiffness);
  if (check.accepted) return;
  std::ostringstream sentence;
  sentence << "the field is too stiff for a device of this damping at this rate: " << describe(check.error) << "; set stiffness to at most "
           << std::floor(to_double(check.stiffness) * 1000) / 1000 << " N/mm";
  throw InputError(sentence.str());
}

}  // namespace

isotouch_status isotouch_touch_new(isotouch_field field, const isotouch_settings* settings, size_t size, isotouch_touch* touch) {
  return guarded(ISOTOUCH_BAD_DATA, [&] {
    required(touch, "touch");
    require_optional(settings, size, "isotouch_settings");
    const isotouch_settings wanted = settings != nullptr ? *settings : default_settings();
    if (wanted.record_ticks > kMaxKept)
      refuse(ISOTOUCH_BAD_ARGUMENT, "record_ticks is " + std::to_string(wanted.record_ticks) + " and may be at most " +
                                        std::to_string(kMaxKept) + "; keep fewer ticks");
    const TraceHeader header = header_of(wanted);
    const Held held(field, Kind::kField, Use::kShared);
    const auto& on = held.as<FieldThing>().open;
    require_stable(on->view, header);
    *touch = add(std::make_unique<TouchThing>(on, header, static_cast<std::size_t>(wanted.record_ticks)));
  });
}

isotouch_status isotouch_touch_position(isotouch_touch touch, const double* hip_mm, uint32_t buttons, isotouch_felt* felt, size_t size) {
  return guarded(ISOTOUCH_BAD_DATA, [&] {
    require_struct(felt, "felt", size, "isotouch_felt");
    require_finite(required(hip_mm, "hip_mm"), 3, "hip_mm");
    require_bits(buttons, kButtons, "buttons");
    const Held held(touch, Kind::kTouch, Use::kAlone);
    auto& on = held.as<TouchThing>();
    require_kind(on, InputKind::kPosition);
    *felt = step(on, position_of(hip_mm, buttons));
  });
}

isotouch_status isotouch_touch_counts(isotouch_touch touch, const int32_t* counts, uint32_t homed, uint32_t buttons, isotouch_felt* felt,
                                      size_t size) {
  return guarded(ISOTOUCH_BAD_DATA, [&] {
    require_struct(felt, "felt", size, "isotouch_felt");
    required(counts, "counts");
    require_bits(homed, kHomed, "homed");
    require_bits(buttons, kButtons, "buttons");
    const Held held(touch, Kind::kTouch, Use::kAlone);
    auto& on = held.as<TouchThing>();
    require_kind(on, InputKind::kPacket);
    *felt = step(on, packet_of(counts, homed, buttons));
  });
}

isotouch_status isotouch_touch_missed(isotouch_touch touch, isotouch_felt* felt, size_t size) {
  return guarded(ISOTOUCH_BAD_DATA, [&] {
    require_struct(felt, "felt", size, "isotouch_felt");
    const Held held(touch, Kind::kTouch, Use::kAlone);
    auto& on = held.as<TouchThing>();
    if (!on.last) refuse(ISOTOUCH_BAD_ARGUMENT, "no sample has come yet, so none can be missed; begin with a position or with counts");
    Input input = *on.last;
    input.fresh = false;
    if (input.age < UINT16_MAX) ++input.age;
    *felt = step(on, input);
  });
}

isotouch_status isotouch_touch_request(isotouch_touch touch, uint32_t requests) {
  return guarded(ISOTOUCH_BAD_DATA, [&] {
    static_assert(std::uint32_t{ISOTOUCH_STOP} == kRequestStop && std::uint32_t{ISOTOUCH_RESUME} == kRequestResume);
    require_bits(requests, kRequestStop | kRequestResume, "requests");
    const Held held(touch, Kind::kTouch, Use::kAlone);
    std::uint8_t& asked = held.as<TouchThing>().requests;
    asked = static_cast<std::uint8_t>(asked | requests);  // what was asked for before still holds
  });
}

isotouch_status isotouch_touch_path(isotouch_touch touch, size_t ticks, const double* hip_mm, isotouch_felt* felt, size_t size) {
  return guarded(ISOTOUCH_BAD_DATA, [&] {
    require_count(ticks, sizeof *felt, "ticks");
    require_size(size, ticks * sizeof *felt, "felt");
    const Held held(touch, Kind::kTouch, Use::kAlone);
    auto& on = held.as<TouchThing>();
    require_kind(on, InputKind::kPosition);
    if (ticks == 0) return;
    require_finite(required(hip_mm, "hip_mm"), 3 * ticks, "hip_mm");
    required(felt, "felt");
    for (std::size_t tick = 0; tick < ticks; ++tick) felt[tick] = step(on, position_of(hip_mm + 3 * tick, 0));
  });
}

isotouch_status isotouch_touch_save(isotouch_touch touch, const char* path, uint64_t* ticks) {
  return guarded(ISOTOUCH_BAD_DATA, [&] {
    const std::string name = file_name(path);
    const Held held(touch, Kind::kTouch, Use::kAlone);
    const auto& on = held.as<TouchThing>();
    if (on.recorded() == 0) refuse(ISOTOUCH_MISSING, "no tick of this touch was kept; set record_ticks before it begins, and touch");
    trace::TraceWriter writer(name, on.run.header());
    for (std::uint64_t tick = 0; tick < on.recorded(); ++tick) writer.append(on.kept[static_cast<std::size_t>(tick)]);
    writer.finish();
    if (ticks != nullptr) *ticks = on.recorded();
  });
}

const char* isotouch_state_name(uint32_t state) {
  return files::state_name(state > UINT16_MAX ? std::uint16_t{UINT16_MAX} : static_cast<std::uint16_t>(state));
}
