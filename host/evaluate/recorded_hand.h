/// The hand of a trace, whatever it touched.
#pragma once

#include "host/evaluate/felt_hands.h"
#include "host/trace/trace_file.h"

namespace isotouch::evaluate {

/// returns   positions one a millisecond, straight between the trace's ticks where its period is another
/// fails     InputError: fewer than two ticks, or packets without outputs, which say where the hand was only through the device's model
RecordedHand recorded_hand(const trace::Trace& trace);

}  // namespace isotouch::evaluate
