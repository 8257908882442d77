/// The program's own letters: every character is a few strokes, so it stays smooth at any size and angle.
///
/// A letter lives on a lattice with the base line at y = 0 and y up: capitals are 7 high, small letters 5, descenders reach to -2.2.
#pragma once

#include <string_view>
#include <vector>

#include "host/view/canvas.h"

namespace isotouch::view {

inline constexpr float kCapitalHeight = 7;

struct Glyph {
  float width = 0;                ///< of the ink; the next letter begins kLetterGap to the right of it
  std::vector<Polyline> strokes;  ///< lattice units, y up
};
inline constexpr float kLetterGap = 1.95F;

/// The strokes of a Unicode character: printable ASCII and ° ± · − – × µ ² φ; anything else is a box.
const Glyph& glyph(char32_t character);

/// Is there a drawing of this character's own?
bool has_glyph(char32_t character);

/// UTF-8 → characters; a byte that is not UTF-8 becomes U+FFFD.
std::u32string decode_utf8(std::string_view text);

}  // namespace isotouch::view
