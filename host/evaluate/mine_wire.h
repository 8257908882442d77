/// What goes wrong on a wire, put into a recording at the wire: the same hand, but the packets, lines and people around it misbehave.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "shared/device_trace.h"

namespace isotouch::evaluate {

/// wrap      the encoders' reference is moved so that their 16 bits wrap in the middle of the motion; the mechanism stands where it stood
/// faults    every 220 to 580 ticks one of: packets missing (1 to 8, or 150), malformed packets, late ticks (up to 20, or 150), a stop, the emergency stop, the enable
///           wrong, a jump of one encoder and back, the homing bits lost, a device that was without power, the field taken away, a restart, a button,
///           one that is stuck while somebody stops; and a person who resumes
/// resume    every 200 to 300 ticks a person resumes, whatever there was
/// grip      the device gives forces only while a button is held: for 100 to 400 ticks, then not for 20 to 100
/// settings  every 40 to 200 ticks one of the settings that may change takes a drawn value
const std::vector<std::string>& mined_wires();

/// Inputs alone; what a tick answers is a replay's business.
struct WireRecording {
  DeviceTraceHeader header;
  std::vector<DeviceInput> inputs;
};

/// The same for the same recording and seed on every machine.
///
/// fails     InputError: an unknown kind
WireRecording mine_wire(const WireRecording& recording, const std::string& kind, std::uint64_t seed);

}  // namespace isotouch::evaluate
