/// Quantiles as a JSON object: null where there was no value.
#pragma once

#include <nlohmann/json.hpp>

#include "host/quantiles.h"

namespace isotouch::commands {

inline nlohmann::ordered_json quantiles_json(const Quantiles& of) {
  if (of.count == 0) return {{"median", nullptr}, {"p95", nullptr}, {"p99", nullptr}, {"max", nullptr}};
  return {{"median", of.median}, {"p95", of.p95}, {"p99", of.p99}, {"max", of.max}};
}

}  // namespace isotouch::commands
