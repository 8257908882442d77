/// How wide the vectors of this machine are.
#pragma once

#include <cstddef>

namespace isotouch::field {

/// Numbers in a vector: 4, 8 (on x86-64: AVX2) or 16 (AVX-512). Sources that are compiled for each give the same bits.
std::size_t vector_lanes();

}  // namespace isotouch::field
