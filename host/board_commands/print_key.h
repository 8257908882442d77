/// One value of what a command prints with --json, for scripts that have no reader of JSON.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

namespace isotouch::commands {

/// Prints a text without quotation marks, the parts of a list separated by spaces, an empty line for null.
///
/// name      a key, or keys joined by dots: "tick_us.p999"
/// fails     UsageError that lists the keys there are; InputError where the first part is one: what an object within has may depend on the controller
void print_key(const nlohmann::ordered_json& json, const std::string& name);

}  // namespace isotouch::commands
