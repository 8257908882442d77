/// Hostile recordings, derived from recorded or made ones: what a replay must survive and nobody makes by chance.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "shared/field_view.h"
#include "shared/trace.h"

namespace isotouch::motion {

/// Inputs alone; what a tick answers is for a replay to find.
struct Recording {
  TraceHeader header;
  std::vector<Input> inputs;
};

struct Mutation {
  std::string_view name;
  InputKind of;      ///< what its recordings hold
  bool keeps_ticks;  ///< each tick comes of the recorded one of its number
  std::string_view meaning;
};

/// All of them, those of positions first.
std::span<const Mutation> mutations();

/// nullptr: there is no such mutation
const Mutation* find_mutation(std::string_view name);

/// The same for the same recording, field and seed on every machine.
///
/// recording in the workspace of `field`, with inputs of the mutation's kind
/// fails     InputError: an unknown name; a hand that never moves (fast), or never comes near the surface (dwell, medial, graze, leave); a field that
///           was patched meanwhile, where the mutation does not keep the ticks
Recording mutate(const Recording& recording, std::string_view name, const FieldView& field, std::uint64_t seed);

}  // namespace isotouch::motion
