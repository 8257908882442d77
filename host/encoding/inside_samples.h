/// How much of a blob's grid is inside the object.
#pragma once

#include <cstddef>

#include "shared/blob.h"

namespace isotouch::encoding {

/// Samples with a negative coefficient, stored or not. Constant nodes and bricks are counted by the piece.
std::size_t inside_samples(const BlobView& view);

}  // namespace isotouch::encoding
