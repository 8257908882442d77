/// The mutations of positions, see `mutate.h`.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "host/motion/hand.h"
#include "shared/field_view.h"
#include "shared/tick_io.h"

namespace isotouch::motion {

struct MutationOptions {
  std::string kind;  ///< the name of one
  std::uint64_t seed = 1;
  std::uint32_t period_ns = 1'000'000;
};

/// The same ticks for the same hand, field and seed on every machine.
///
/// hand      in the workspace of `field`
/// emit      takes the ticks in their order
/// returns   how many
/// fails     InputError: an unknown kind; a hand that never moves (fast), or never comes near the surface (dwell, medial, graze, leave)
std::uint64_t mutate_hand(const std::vector<Input>& hand, const FieldView& field, const MutationOptions& options, Hand::Emit emit);

}  // namespace isotouch::motion
