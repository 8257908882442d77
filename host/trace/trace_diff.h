/// Where two runs part: the first tick and the field in it.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "host/trace/trace_file.h"

namespace isotouch::trace {

struct Difference {
  std::uint64_t tick = 0;
  std::string
      field;  ///< a field of SPEC.md's record, as `differing_input` and `differing_output` name it, or one that the function which found it states
};

/// fails     InputError naming the file: it has no outputs or no records
void require_a_recording(const Trace& trace);

/// Compares two traces with recorded outputs. Both are first checked against their own chains; then equal chains mean equal histories, so
/// the first tick that differs is found by bisection, in log2(ticks) look-ups. Where bytes were changed after recording, all records are compared.
///
/// returns   nothing when they are equal to the bit, arrival times apart; field is also one of
///           field, model, period, settings (the headers differ: tick 0), length (one ends earlier, equal until there), chain (nothing else differs
///           there, so one was changed)
/// fails     as require_a_recording
std::optional<Difference> first_difference(const Trace& a, const Trace& b);

}  // namespace isotouch::trace
