#include "shared/files/state_text.h"

#include <array>
#include <cstddef>
#include <string_view>

#include "shared/fault_names.h"

namespace isotouch::files {

namespace {

struct State {
  const char* name;
  std::string_view sentence;
};

/// In the order of SupervisorState.
constexpr std::array<State, 7> kStates = {{
    {"boot", ": no packet of a device has come yet; plug it in, and switch its power supply on"},
    {"homing", ": pull the grip out as far as it goes, then push it in"},
    {"idle", ": "},
    {"ready", ": hold a button of the grip, if the settings require one for force"},
    {"active", ": the object can be felt"},
    {"hold", ": no force for a moment, because "},
    {"fault", ": no force, because "},
}};

struct Cause {
  std::uint32_t bit;
  std::string_view sentence;
};

/// Why a hold lasts: the first that holds.
constexpr std::array<Cause, 4> kHoldCauses = {{
    {kPoseUncertain, "the position of the grip is uncertain; move it slowly, and home it again if this does not end"},
    {kTooFast, "the grip moves too fast; move it more slowly"},
    {kStale, "packets of the device are missing; check its cable if this does not end"},
    {kBadReply, "packets of the device are malformed; check its cable if this does not end"},
}};
constexpr std::string_view kNoField = "there is no field; send one with 'isotouch upload'";
constexpr std::string_view kNotYet = "no force yet, because ";  // the field waits for what a hold waits for
constexpr std::string_view kLateTicks = "ticks came late; see 'isotouch latency' if this does not end";

std::string_view hold_cause(std::uint32_t status) {
  for (const Cause& cause : kHoldCauses) {
    if ((status & cause.bit) != 0) return cause.sentence;
  }
  return kLateTicks;
}

std::string fault_causes(std::uint16_t faults) {
  std::string text;
  for (const FaultName& fault : kFaultNames) {
    if ((faults & fault.fault) != 0) text.append(text.empty() ? "" : "; ").append(fault.sentence);
  }
  return text;
}

std::string way_out(std::uint16_t faults) {
  const bool of_service = (faults & kServiceFaults) != 0;
  return std::string("; then press a button of the grip, or ") + (of_service ? "let somebody with the role service run" : "run") +
         " 'isotouch resume'";
}

}  // namespace

std::string_view angles_text(protocol::OtherAngles others) {
  switch (others) {
    case protocol::OtherAngles::kNone: return "";
    case protocol::OtherAngles::kKept:
      return "other angles were measured for this device, so it gets no force until the controller has started again with them; that waits "
             "until nobody records or sends a field; where [files] record has begun, you must start it";
    case protocol::OtherAngles::kUntrusted: break;
  }
  return "the angles in use are not those of the device that answers, so it gets no force until the controller has started again with its "
         "own; "
         "that waits until nobody records or sends a field; where [files] record has begun with another device, you must start it";
}

const char* state_name(std::uint16_t state) { return state < kStates.size() ? kStates[state].name : "unknown"; }

namespace {

/// For people who have `isotouch`.
std::string text_of(const Condition& condition, protocol::OtherAngles others) {
  std::string text = state_name(condition.state);
  const auto state = static_cast<SupervisorState>(condition.state);
  if (others != protocol::OtherAngles::kNone) {  // neither a button nor a resume is heard now
    const auto heard = static_cast<std::uint16_t>(condition.faults & ~kFaultSilent);
    const bool has_causes = state == SupervisorState::kFault && heard != 0;
    text += has_causes ? std::string(kStates[condition.state].sentence) + fault_causes(heard) + "; besides, " : ": ";
    return text.append(angles_text(others));
  }
  if (condition.state >= kStates.size()) return text;
  text += kStates[condition.state].sentence;
  switch (state) {
    case SupervisorState::kIdle:
      return condition.has_field ? text.append(kNotYet).append(hold_cause(condition.status)) : text.append(kNoField);
    case SupervisorState::kHold: return text.append(hold_cause(condition.status));
    case SupervisorState::kFault: return text.append(fault_causes(condition.faults)).append(way_out(condition.faults));
    default: return text;
  }
}

}  // namespace

std::string state_text(const Condition& condition, protocol::OtherAngles others, std::string_view tool) {
  constexpr std::string_view kCalled = "'isotouch ";
  std::string text = text_of(condition, others);
  for (std::size_t at = text.find(kCalled); at != std::string::npos; at = text.find(kCalled, at + tool.size()))
    text.replace(at + 1, kCalled.size() - 2, tool);
  return text;
}

}  // namespace isotouch::files
