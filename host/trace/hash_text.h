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

/// Is it written so?
inline bool is_hash_text(const std::string& text) {
  return text.size() == 16 && text.find_first_not_of("0123456789abcdef") == std::string::npos;
}

}  // namespace isotouch::trace
