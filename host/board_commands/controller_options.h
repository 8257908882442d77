/// What all commands that speak with a controller have in common.
#pragma once

#include <CLI/CLI.hpp>
#include <string>

#include "host/link/words.h"
#include "shared/files/state_text.h"
#include "shared/printable.h"
#include "shared/protocol_messages.h"

namespace isotouch::commands {

/// --to ADDRESS, of a controller that may be named.
///
/// what      before its two forms
inline CLI::Option* add_optional_address(CLI::App& command, std::string& address, const std::string& what = "the controller: ") {
  return command.add_option("--to", address, what + "unix:PATH of its socket, or ssh://user@host[:port][/path of the socket]");
}

/// The same, required.
inline void add_address(CLI::App& command, std::string& address) { add_optional_address(command, address)->required(); }

/// For `option->check(...)` of a field's name: one that the protocol would have to cut or change is wrong usage.
inline CLI::Validator field_name() {
  const auto check = [](std::string& text) -> std::string {
    if (!is_printable(text)) return "a field's name has no control characters and is UTF-8";
    if (!text.empty() && text.size() <= protocol::kMaxName) return {};
    return "a field's name has 1 to " + std::to_string(protocol::kMaxName) + " bytes, and this one " + std::to_string(text.size());
  };
  return {check, "", "field name"};
}

using files::state_name;
using link::degrees_of;
using link::fault_names;
using link::in_unit;
using link::kMeasureNames;
using link::MeasureName;

}  // namespace isotouch::commands
