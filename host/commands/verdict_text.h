/// A verdict for programs and for people.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "host/field/verdict.h"
#include "host/live/verdict.h"

namespace isotouch::commands {

nlohmann::ordered_json to_json(const field::Verdict& verdict);
nlohmann::ordered_json to_json(const live::Verdict& verdict);

/// "plausible; noise 3.1 % of the spacing, …"
std::string in_words(const field::Verdict& verdict);
std::string in_words(const live::Verdict& verdict);

}  // namespace isotouch::commands
