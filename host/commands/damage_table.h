/// The part of `isotouch evaluate` that tells what noise, outliers and turned normals cost.
#pragma once

#include <cstddef>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "host/evaluate/shape_trial.h"
#include "host/evaluate/surface_error.h"
#include "host/field/build_field.h"

namespace isotouch::commands {

struct DamageRow {
  std::string shape;
  std::string damage;  ///< one of `evaluate::kDamages`
  evaluate::SurfaceError error;
  std::size_t components = 0;  ///< pieces and cavities of the field's surface; 1 is sound
  field::Repair repair;
};

/// One trial under every damage, by the default method.
std::vector<DamageRow> damage_rows(const evaluate::ShapeTrial& trial);

nlohmann::ordered_json to_json(const std::vector<DamageRow>& rows);
void print(const std::vector<DamageRow>& rows);

}  // namespace isotouch::commands
