/// What a build found, for programs.
#pragma once

#include <nlohmann/json.hpp>

#include "host/commands/built_field.h"

namespace isotouch::commands {

struct KindNames {
  const char* kind;   ///< "cloud"
  const char* items;  ///< what it is made of: "points"
};

KindNames names_of(SourceKind kind);

nlohmann::ordered_json to_json(const BuildReport& report, const FieldView& view);

/// What is known of a field that was refused.
nlohmann::ordered_json refused_json(const BuildReport& report);

}  // namespace isotouch::commands
