/// How a field feels, as C sets it, and as the header of a trace has it.
#pragma once

#include "host/library/isotouch.h"
#include "shared/trace.h"

namespace isotouch::library {

isotouch_settings default_settings();

/// fails     CallError naming the member and its range
TraceHeader header_of(const isotouch_settings& settings);

}  // namespace isotouch::library
