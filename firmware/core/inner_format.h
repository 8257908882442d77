/// The number format inside a sampler: 20 fraction bits. Coefficients are within ±8, so a second difference is within ±32: 2^25.
#pragma once

#include <cstdint>

#include "shared/field_view.h"
#include "shared/units.h"

namespace isotouch::core {

inline constexpr int kInnerBits = 20;
inline constexpr int kRaisedBits = kInnerBits - Distance::kFractionBits;  ///< by which a coefficient is raised

constexpr std::int32_t to_inner(std::int16_t coefficient) { return std::int32_t{coefficient} * (1 << kRaisedBits); }

/// Rounded to the 16 fraction bits of a sample; of one number, or of several at once.
template <class Number>
constexpr Number to_outer(Number inner) {
  constexpr int kSpare = kInnerBits - Voxel::kFractionBits;
  return (inner + (1 << (kSpare - 1))) >> kSpare;
}

}  // namespace isotouch::core
