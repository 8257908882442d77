/// A recorded hand, whichever version its file has: positions and forces, tick by tick.
#pragma once

#include <filesystem>

#include "host/evaluate/trace_file.h"

namespace isotouch::evaluate {

/// Of a recording at the wire: what its ticks said of the HIP and the force. Where the HIP was not known there is no contact. The blob is the recording's,
/// the device model is left behind, and the chain is one of positions.
///
/// fails     InputError as TraceFile::read; of a recording at the wire without outputs
Trace read_hand(const std::filesystem::path& file);

}  // namespace isotouch::evaluate
