/// What a command prints with --json.
#pragma once

#include <nlohmann/json.hpp>

namespace isotouch::commands {

/// indent    as json_text has it
void print_json(const nlohmann::ordered_json& json, int indent = 2);

}  // namespace isotouch::commands
