/// Text from elsewhere, for a terminal: no character of it may move the cursor, change colours or turn the order of what is shown.
///
/// tick      yes
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

namespace isotouch {

namespace printable_detail {

/// C0 and C1 controls, DEL, line and paragraph separators, and whatever turns the direction of writing.
constexpr bool is_harmful(std::uint32_t c) {
  return c < 0x20 || (c >= 0x7F && c < 0xA0) || c == 0x061C || (c >= 0x200E && c <= 0x200F) || (c >= 0x2028 && c <= 0x202E) ||
         (c >= 0x2066 && c <= 0x2069);
}

constexpr std::uint8_t byte(std::string_view text, std::size_t at) { return static_cast<std::uint8_t>(text[at]); }

}  // namespace printable_detail

/// Bytes of the character that a text begins with; 0 where it is none that a terminal may get: harmful, or no UTF-8.
///
/// text      not empty
constexpr std::size_t printable_size(std::string_view text) {
  using namespace printable_detail;
  const std::uint8_t first = byte(text, 0);
  const std::size_t size = first < 0x80 ? 1 : first >> 5 == 6 ? 2 : first >> 4 == 14 ? 3 : first >> 3 == 30 ? 4 : 0;
  if (size == 0 || size > text.size()) return 0;
  std::uint32_t character = size == 1 ? first : first & (0x7FU >> size);
  for (std::size_t i = 1; i < size; ++i) {
    if (byte(text, i) >> 6 != 2) return 0;
    character = character << 6 | (byte(text, i) & 0x3FU);
  }
  constexpr std::uint32_t kLeast[] = {0, 0, 0x80, 0x800, 0x10000};
  const bool is_character = character >= kLeast[size] && character < 0x110000 && (character < 0xD800 || character > 0xDFFF);
  return is_character && !is_harmful(character) ? size : 0;
}

/// Is every character of a text one that a terminal may get?
constexpr bool is_printable(std::string_view text) {
  while (!text.empty()) {
    const std::size_t size = printable_size(text);
    if (size == 0) return false;
    text.remove_prefix(size);
  }
  return true;
}

/// Replaces every byte of what a terminal must not get.
constexpr void make_printable(std::span<char> text, char instead) {
  while (!text.empty()) {
    const std::size_t size = printable_size({text.data(), text.size()});
    if (size == 0) text.front() = instead;
    text = text.subspan(size == 0 ? 1 : size);
  }
}

}  // namespace isotouch
