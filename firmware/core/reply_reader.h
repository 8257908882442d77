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
  std::uint32_t left_out = 0;  ///< ticks left out before those with a new packet, since the last valid one
  bool heard = false;          ///< there was a valid packet
  bool all_homed = false;      ///< the newest one called all three legs homed
  bool homed = false;          ///< latched: two packets in a row called all legs homed
};

/// What a tick knows from the device.
struct Reading {
  bool fresh = false;      ///< a new valid packet
  bool jumped = false;     ///< the counts took another reference, or no hand moved them: what was computed from the old ones is void
  bool malformed = false;  ///< there was a packet, but not a valid one
};

/// Reads the newest packet. If the counts jump while the device does not report that it is homed, the reference is lost and homing begins again. Without
/// a jump the reference stays, because sources disagree on whether the device keeps its homed bits. While bits are missing, an eighth of the usual jump is
/// enough, and so are counts of zero: a leg that finds its mark again begins a new count there. Bits
/// that disappear while ticks were left out lose the reference in any case, and so does a packet without bits after kMaxLate ticks left out or without a
/// valid packet: in that time the device may have begun anew.
///
/// fails     never: a malformed packet counts as none
/// tick      yes
Reading read_reply(const Input& in, const DeviceModel& device, ReplyState& state);

}  // namespace isotouch::core
