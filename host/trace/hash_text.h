/// How a hash is shown: 16 lower-case hexadecimal digits (shared/SPEC.md).
#pragma once

#include <cstdint>
#include <string>

namespace isotouch::trace {

inline std::string hash_text(std::uint64_t hash) {
  std::string text(16, '0');
  for (std::size_t i = 0; i < 16; ++i) text[15 - i] = "0123456789abcdef"[(hash >> (4 * i)) & 0xF];
  return text;
}

}  // namespace isotouch::trace
