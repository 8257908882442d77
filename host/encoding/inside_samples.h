/// How much of a field's grid is inside the object.
#pragma once

#include <cstddef>

#include "shared/field_view.h"

namespace isotouch::encoding {

/// Samples with a negative coefficient, stored or not. Constant nodes and bricks are counted by the piece.
std::size_t inside_samples(const FieldView& view);

}  // namespace isotouch::encoding
