/// Which role a request takes: the one table of what each role may ask.
#pragma once

#include <cstdint>

#include "shared/fault_names.h"
#include "shared/protocol.h"
#include "shared/protocol_messages.h"

namespace isotouch::control {

/// The lowest role that may send a request of this kind. Some requests need a higher one, by their content or by the state of the controller: see
/// `role_after`, `role_for_worst` and `settings::LiveSettings::set`.
constexpr protocol::Role role_for(protocol::Kind request) {
  using protocol::Kind, protocol::Role;
  switch (request) {
    case Kind::kBegin:
    case Kind::kBeginPatch:
    case Kind::kChunk:
    case Kind::kCommit:
    case Kind::kAbort:
    case Kind::kSelect:
    case Kind::kSet:
    case Kind::kResume:
    case Kind::kRecord: return Role::kOperate;  // a recording begins a run anew: the force goes, and rises by a ramp
    case Kind::kPosture:
    case Kind::kCalibrate: return Role::kService;
    default: return Role::kWatch;  // a stop among them
  }
}

/// For a resume, and for a recording, which begins a run anew: after a fault of what watches over the controller somebody has to look for its cause first.
///
/// faults    TickRecord::faults of the newest tick
constexpr protocol::Role role_after(std::uint16_t faults) {
  return (faults & kServiceFaults) != 0 ? protocol::Role::kService : protocol::Role::kOperate;
}

/// Whoever lets the controller forget its worst ticks takes them from everybody.
constexpr protocol::Role role_for_worst(bool anew) { return anew ? protocol::Role::kOperate : protocol::Role::kWatch; }

}  // namespace isotouch::control
