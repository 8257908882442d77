#include "host/view/text.h"

#include <cairo.h>

#include <numbers>
#include <string>

#include "shared/printable.h"

namespace isotouch::view {
namespace {

/// Cairo takes no text that is not UTF-8.
std::string in_utf8(std::string_view text) {
  std::string good;
  while (!text.empty()) {
    const std::size_t size = printable_size(text);
    good.append(size == 0 ? "\uFFFD" : text.substr(0, size));
    text.remove_prefix(size == 0 ? 1 : size);
  }
  return good;
}

/// The pen with the font of a style; nothing is fitted to pixels, so that a picture is the same at every scale.
void choose_font(cairo_t* pen, const TextStyle& style) {
  cairo_select_font_face(pen, "sans-serif", CAIRO_FONT_SLANT_NORMAL, style.bold ? CAIRO_FONT_WEIGHT_BOLD : CAIRO_FONT_WEIGHT_NORMAL);
  cairo_font_options_t* options = cairo_font_options_create();
  cairo_font_options_set_hint_style(options, CAIRO_HINT_STYLE_NONE);
  cairo_font_options_set_hint_metrics(options, CAIRO_HINT_METRICS_OFF);
  cairo_font_options_set_antialias(options, CAIRO_ANTIALIAS_GRAY);
  cairo_set_font_options(pen, options);
  cairo_font_options_destroy(options);
  constexpr double kTrial = 100;
  cairo_set_font_size(pen, kTrial);
  cairo_text_extents_t capital;
  cairo_text_extents(pen, "H", &capital);
  if (capital.height > 0) cairo_set_font_size(pen, kTrial * static_cast<double>(style.capital) / capital.height);
}

double width_of(cairo_t* pen, const std::string& text) {
  cairo_text_extents_t extents;
  cairo_text_extents(pen, text.c_str(), &extents);
  return extents.x_advance;
}

double shift(Anchor anchor, double length) { return anchor == Anchor::kStart ? 0 : anchor == Anchor::kMiddle ? -length / 2 : -length; }

}  // namespace

void draw_text(Canvas& canvas, Point at, std::string_view text, const TextStyle& style) {
  const std::string letters = in_utf8(text);
  canvas.with_pen(style.colour, 1, [&](cairo_t* pen) {
    choose_font(pen, style);
    cairo_translate(pen, static_cast<double>(at.x), static_cast<double>(at.y));
    if (style.upward) cairo_rotate(pen, -std::numbers::pi / 2);
    cairo_move_to(pen, shift(style.along, width_of(pen, letters)), -shift(style.across, static_cast<double>(style.capital)));
    cairo_show_text(pen, letters.c_str());
  });
}

float text_width(std::string_view text, const TextStyle& style) {
  Picture scratch(1, 1);
  choose_font(scratch.pen(), style);
  return static_cast<float>(width_of(scratch.pen(), in_utf8(text)));
}

}  // namespace isotouch::view
