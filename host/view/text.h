/// Words on a picture, in the sans-serif font of the system.
#pragma once

#include <string_view>

#include "host/view/canvas.h"

namespace isotouch::view {

enum class Anchor { kStart, kMiddle, kEnd };

struct TextStyle {
  float capital = 9;  ///< height of a capital letter, pixels
  Colour colour = srgb(0x2B3440);
  Anchor along = Anchor::kStart;   ///< which part of the line stands at the given point
  Anchor across = Anchor::kStart;  ///< start: the base line; middle: half the capitals' height; end: the capitals' top
  bool upward = false;             ///< turned by 90°, read from bottom to top
  bool bold = false;
};

/// Draws one line of UTF-8 text; in the place of a byte that is none stands U+FFFD.
void draw_text(Canvas& canvas, Point at, std::string_view text, const TextStyle& style);

/// Its length in pixels.
float text_width(std::string_view text, const TextStyle& style);

}  // namespace isotouch::view
