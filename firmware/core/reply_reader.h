/// Reply packets → counts that can be trusted: which sample is new, whether the device knows its reference, and where the counts jumped.
#pragma once

#include <cstdint>

#include "firmware/core/joint_angles.h"
#include "shared/device_model.h"
#include "shared/tick_io.h"

namespace isotouch::core {

struct ReplyState {
  Counts counts{};
  std::uint8_t buttons = 0;
  std::uint32_t stale = 0;     ///< ticks since the last valid fresh packet
  std::uint32_t in_a_row = 0;  ///< valid packets in a row that call all three legs homed, at most 2
  bool heard = false;          ///< there was a valid packet
  bool homed = false;          ///< latched: two packets in a row called all legs homed
};

/// What a tick knows from the device.
struct Reading {
  bool fresh = false;      ///< a new valid packet
  bool jumped = false;     ///< the counts took another reference, or no hand moved them: what was computed from the old ones is void
  bool malformed = false;  ///< there was a packet, but not a valid one
};

/// Takes the newest packet. Where the counts jump while the device does not call itself homed, the reference is lost and homing begins again;
/// otherwise "homed" stays, because sources disagree on whether the bits do. In the packet in which the bits go, an eighth of a jump is one, or counts of zero.
///
/// fails     never: a malformed packet counts as none
/// tick      yes
Reading read_reply(const Input& in, const DeviceModel& device, ReplyState& state);

}  // namespace isotouch::core
