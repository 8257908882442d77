/// Where two runs part: the first tick and the field in it.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "host/evaluate/trace_file.h"
#include "shared/trace.h"

namespace isotouch::evaluate {

struct Difference {
  std::uint64_t tick = 0;
  std::string field;  ///< a name of `differing_input` or `differing_output`, or one that the function which found it states
};

/// The first that differs of: hip.x hip.y hip.z buttons fresh age; nullptr when none does.
const char* differing_input(const TickInput& a, const TickInput& b);

/// The first that differs of: proxy.x .y .z force.x .y .z words[0] [1] [2] state status; nullptr when none does.
const char* differing_output(const TickOutput& a, const TickOutput& b);

/// The first that differs of: packet fresh age commands field; nullptr when none does.
const char* differing_input(const DeviceInput& a, const DeviceInput& b);

/// The first that differs of: hip.x .y .z, those of a TickOutput, faults flags buttons; nullptr when none does.
const char* differing_output(const DeviceOutput& a, const DeviceOutput& b);

/// Compares two traces with recorded outputs. Both are first checked against their own chains; then equal chains mean equal histories, so
/// the first tick that differs is found by bisection, in log2(ticks) look-ups.
///
/// returns   nothing when they are equal to the bit, arrival times apart; field is also one of
///           blob, model, period, settings (the headers differ: tick 0), length (one ends earlier, equal until there)
/// fails     InputError when one has no outputs or no records, or when its bytes were changed after recording
template <class Format>
std::optional<Difference> first_difference(const TraceFile<Format>& a, const TraceFile<Format>& b);

}  // namespace isotouch::evaluate
