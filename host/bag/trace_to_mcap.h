/// A trace as an MCAP file, which Foxglove and the tools of ROS 2 open.
#pragma once

#include <functional>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "host/bag/mcap_writer.h"
#include "shared/files/trace_file.h"

namespace isotouch::bag {

/// Topics: `/isotouch/tick`, one JSON object a tick, and `/isotouch/hip`, `/isotouch/proxy`, places for three-dimensional views, in metres. The trace itself
/// is attached, and its patches, so that it comes back to the bit.
///
/// whole       the bytes of the trace's file
/// patches     the bytes of the file beside it; nothing where the field was not patched
/// name        of the trace, for the attachments
/// library     name and version of the program that writes
/// row         the object of a tick; its members are numbers, strings or null
///
/// Times are those of the ticks from 0 on, in ns.
Bytes trace_to_mcap(const files::TraceFile& trace, const std::string& name, std::span<const std::uint8_t> whole,
                    const std::optional<std::vector<std::uint8_t>>& patches, const std::string& library,
                    const std::function<nlohmann::ordered_json(std::size_t tick)>& row);

}  // namespace isotouch::bag
