#include "host/view/axes.h"

#include <algorithm>
#include <cmath>

#include "host/view/caption.h"
#include "host/view/text.h"

namespace isotouch::view {
namespace {

double step_of(const std::vector<double>& values) { return values.size() > 1 ? values[1] - values[0] : 1; }

}  // namespace

Rect frame_in(const Rect& place, float scale) {
  return {place.left + 78 * scale, place.top + 34 * scale, place.right - 24 * scale, place.bottom - 48 * scale};
}

std::vector<double> ticks(double low, double high, int most) {
  const double least = (high - low) / std::max(1, most - 1);
  if (!(least > 0) || !std::isnormal(least)) return {};
  double step = round_length(least);
  while (std::floor(high / step + 1e-9) - std::ceil(low / step - 1e-9) + 1 > most) step = round_length(step * 2.5);  // 1 2 5 10
  std::vector<double> values;
  const auto first = static_cast<long long>(std::ceil(low / step - 1e-9)), last = static_cast<long long>(std::floor(high / step + 1e-9));
  for (long long i = first; i <= last; ++i) values.push_back(static_cast<double>(i) * step);
  return values;
}

std::string tick_text(double value, double step) {
  return number(value, std::clamp(static_cast<int>(std::ceil(-std::log10(step) - 1e-9)), 0, 9));
}

Point Axes::at(double x, double y) const {
  return {area_.left + static_cast<float>((x - x_.low) / (x_.high - x_.low)) * area_.width(),
          area_.bottom - static_cast<float>((y - y_.low) / (y_.high - y_.low)) * area_.height()};
}

std::vector<double> Axes::x_ticks(const Canvas& canvas) const {
  return ticks(x_.low, x_.high, std::max(2, static_cast<int>(area_.width() / (80 * drawing_scale(canvas.picture())))));
}

std::vector<double> Axes::y_ticks(const Canvas& canvas) const {
  return ticks(y_.low, y_.high, std::max(2, static_cast<int>(area_.height() / (42 * drawing_scale(canvas.picture())))));
}

void Axes::draw_grid(Canvas& canvas) const {
  const float scale = drawing_scale(canvas.picture());
  for (const double x : x_ticks(canvas)) canvas.line({at(x, 0).x, area_.top}, {at(x, 0).x, area_.bottom}, scale, kGrid);
  for (const double y : y_ticks(canvas)) canvas.line({area_.left, at(0, y).y}, {area_.right, at(0, y).y}, scale, kGrid);
}

void Axes::draw_frame(Canvas& canvas) const {
  const float scale = drawing_scale(canvas.picture());
  const float tick = 5 * scale, capital = 8.5F * scale;
  canvas.frame(area_, 1.2F * scale, kPaleInk);
  const std::vector<double> along = x_ticks(canvas), across = y_ticks(canvas);
  for (const double x : along) {
    const float px = at(x, 0).x;
    canvas.line({px, area_.bottom}, {px, area_.bottom + tick}, 1.2F * scale, kPaleInk);
    draw_text(canvas, {px, area_.bottom + 9 * scale}, tick_text(x, step_of(along)),
              {.capital = capital, .colour = kInk, .along = Anchor::kMiddle, .across = Anchor::kEnd});
  }
  float widest = 0;
  for (const double y : across) {
    const float py = at(0, y).y;
    const std::string text = tick_text(y, step_of(across));
    const TextStyle style{.capital = capital, .colour = kInk, .along = Anchor::kEnd, .across = Anchor::kMiddle};
    canvas.line({area_.left - tick, py}, {area_.left, py}, 1.2F * scale, kPaleInk);
    draw_text(canvas, {area_.left - 9 * scale, py}, text, style);
    widest = std::max(widest, text_width(text, style));
  }
  draw_text(canvas, {(area_.left + area_.right) / 2, area_.bottom + 28 * scale}, x_.label,
            {.capital = capital, .colour = kInk, .along = Anchor::kMiddle, .across = Anchor::kEnd});
  draw_text(canvas, {area_.left - widest - 22 * scale, (area_.top + area_.bottom) / 2}, y_.label,
            {.capital = capital, .colour = kInk, .along = Anchor::kMiddle, .upward = true});
}

}  // namespace isotouch::view
