#include "host/view/text.h"

#include <algorithm>
#include <string>
#include <vector>

#include "host/view/font.h"

namespace isotouch::view {
namespace {

float lattice_width(const std::u32string& letters) {
  float width = 0;
  for (const char32_t letter : letters) width += glyph(letter).width + kLetterGap;
  return letters.empty() ? 0 : width - kLetterGap;
}

float shift(Anchor anchor, float length) { return anchor == Anchor::kStart ? 0 : anchor == Anchor::kMiddle ? -length / 2 : -length; }

}  // namespace

void draw_text(Canvas& canvas, Point at, std::string_view text, const TextStyle& style) {
  const std::u32string letters = decode_utf8(text);
  const float scale = style.capital / kCapitalHeight;
  float x = shift(style.along, lattice_width(letters));
  const float y = shift(style.across, kCapitalHeight);
  std::vector<Polyline> strokes;
  for (const char32_t letter : letters) {
    const Glyph& drawing = glyph(letter);
    for (const Polyline& stroke : drawing.strokes) {
      Polyline& placed = strokes.emplace_back();
      for (const Point& p : stroke) {
        const Point q = Point{p.x + x, p.y + y} * scale;
        placed.push_back(style.upward ? Point{at.x - q.y, at.y - q.x} : Point{at.x + q.x, at.y - q.y});
      }
    }
    x += drawing.width + kLetterGap;
  }
  // Dark strokes on light ground look thinner than they are: never below 1.4 pixels.
  canvas.stroke(strokes, std::max(1.4F, 0.9F * scale) * style.weight, style.colour);
}

float text_width(std::string_view text, const TextStyle& style) {
  return lattice_width(decode_utf8(text)) * style.capital / kCapitalHeight;
}

}  // namespace isotouch::view
