/// Which role a request takes: the one table of what each role may ask.
#pragma once

#include <cstdint>

#include "shared/fault_names.h"
#include "shared/protocol.h"
#include "shared/protocol_messages.h"

namespace isotouch::control {

/// The lowest role that may send a request of this kind. What depends on more than the kind is for `role_for_resume`, `role_for_worst`, and for the
/// settings themselves.
constexpr protocol::Role role_for(protocol::Kind request) {
  using protocol::Kind, protocol::Role;
  switch (request) {
    case Kind::kBegin:
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

/// After a fault of what watches over the controller somebody has to look for its cause first.
constexpr protocol::Role role_for_resume(std::uint16_t faults) {
  return (faults & kServiceFaults) != 0 ? protocol::Role::kService : protocol::Role::kOperate;
}

/// Whoever lets the controller forget its worst ticks takes them from everybody.
constexpr protocol::Role role_for_worst(bool anew) { return anew ? protocol::Role::kOperate : protocol::Role::kWatch; }

}  // namespace isotouch::control
