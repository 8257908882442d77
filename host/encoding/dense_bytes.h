/// What a field would weigh without bricks.
#pragma once

#include <cstdint>

#include "shared/field_view.h"

namespace isotouch::encoding {

/// Bytes of the dense grid of single-precision distances that a field stands for: 4 for each sample of its box.
inline std::uint64_t dense_float_bytes(const FieldView& view) {
  std::uint64_t bytes = 4;
  for (const auto along : view.size) bytes *= static_cast<std::uint64_t>(along);
  return bytes;
}

}  // namespace isotouch::encoding
