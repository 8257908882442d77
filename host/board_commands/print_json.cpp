#include "host/board_commands/print_json.h"

#include <cstdio>

#include "host/files/json_text.h"

namespace isotouch::commands {

void print_json(const nlohmann::ordered_json& json, int indent) { std::printf("%s\n", json_text(json, indent).c_str()); }

}  // namespace isotouch::commands
