/// The module's own memory behind its stack and data: one linear block that only grows. The field stands first in it, the trace behind the field to the end.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace isotouch::touch {

/// Where the block begins, 64-byte aligned.
std::uint8_t* block_begin();

/// The block with at least that many bytes.
///
/// returns   empty when the page gives no more memory
std::span<std::uint8_t> block_of(std::uint64_t bytes);

}  // namespace isotouch::touch
