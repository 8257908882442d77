#include "host/view/legend.h"

#include <vector>

#include "host/view/caption.h"
#include "host/view/text.h"

namespace isotouch::view {

Legend::Legend(Canvas& canvas, const Rect& area)
    : canvas_(canvas), scale_(drawing_scale(canvas.picture())), right_(area.right), base_line_(area.top - 12 * scale_) {}

void Legend::add_line(const std::string& text, Colour colour, float width, bool broken) {
  add(text, [&](const Rect& sign) {
    const float y = (sign.top + sign.bottom) / 2;
    const Polyline sample = {{sign.left, y}, {sign.right, y}};
    canvas_.stroke(broken ? dashed(sample, 7 * scale_, 5 * scale_) : std::vector<Polyline>{sample}, width * scale_, colour);
  });
}

void Legend::add_area(const std::string& text, Colour colour) {
  add(text, [&](const Rect& sign) { canvas_.fill(sign, colour); });
}

void Legend::add(const std::string& text, const std::function<void(const Rect& sign)>& draw_sign) {
  if (text.empty()) return;
  const TextStyle style{.capital = 8.5F * scale_, .colour = kInk, .along = Anchor::kEnd};
  draw_text(canvas_, {right_, base_line_}, text, style);
  right_ -= text_width(text, style) + 8 * scale_;
  draw_sign({right_ - 26 * scale_, base_line_ - 8 * scale_, right_, base_line_});
  right_ -= 48 * scale_;
}

}  // namespace isotouch::view
