/// How `isotouch compare --felt` prints what hands feel.
#pragma once

#include <cstdio>
#include <nlohmann/json.hpp>
#include <string>

#include "host/evaluate/felt_comparison.h"

namespace isotouch::commands {

nlohmann::ordered_json felt_json(const evaluate::FeltComparison& comparison);

/// name      of the field, in front of the table
void print_felt(std::FILE* to, const char* name, const evaluate::FeltComparison& comparison);

/// "slide_100, hand 3, tick 41: 12.3°, 0.1 N".
std::string words_of(const evaluate::FeltPlace& place);

}  // namespace isotouch::commands
