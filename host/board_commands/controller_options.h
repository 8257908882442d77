/// What all commands that speak with a controller have in common.
#pragma once

#include <CLI/CLI.hpp>
#include <string>

#include "host/link/words.h"
#include "shared/files/state_text.h"
#include "shared/protocol_messages.h"

namespace isotouch::commands {

/// --to ADDRESS, required.
inline void add_address(CLI::App& command, std::string& address) {
  command.add_option("--to", address, "the controller: unix:PATH of its socket, or ssh://user@host[:port][/path of the socket]")
      ->required();
}

using files::state_name;
using link::degrees_of;
using link::fault_names;
using link::in_unit;
using link::kMeasureNames;
using link::MeasureName;

/// What is true for the hand, and the next step: see `files::state_text`.
inline std::string state_text(const protocol::StatusReport& status) {
  return files::state_text({status.state, status.faults, status.status, status.generation != 0});
}

}  // namespace isotouch::commands
